#include "seiche/exact/solitary_wave.hpp"

#include <algorithm>

#include <gsl/gsl_sf_expint.h>
#include <boost/math/tools/roots.hpp>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
using SolitarySolution = SolitarySurface::Solution;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Convolution of even values with an odd sequence c(m), folded onto j >= 0; the result is odd.
MatrixXd folded(const Extended& sequence) {
  const Index count = sequence.size() / 2;
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index i = 1; i < count; ++i) {
      const long double direct = i < j ? -sequence[j - i] : sequence[i - j];
      matrix(i, j) = static_cast<double>(j > 0 ? direct + sequence[i + j] : direct);
    }
  }
  return matrix;
}

Extended convolve(const Extended& sequence, const Extended& values) {
  Extended result = Extended::Zero(values.size());
  for (Index i = 1; i < values.size(); ++i) {
    long double sum = values[0] * sequence[i];
    for (Index j = 1; j < values.size(); ++j) {
      sum += values[j] * ((i < j ? -sequence[j - i] : sequence[i - j]) + sequence[i + j]);
    }
    result[i] = sum;
  }
  return result;
}

/// d/ds by the sinc series: (-1)^m/(m spacing).
Extended derivative_sequence(Index count, double spacing) {
  Extended sequence = Extended::Zero(2 * count);
  for (Index m = 1; m < 2 * count; ++m) {
    sequence[m] = (m % 2 == 0 ? 1 : -1) / (static_cast<long double>(spacing) * static_cast<long double>(m));
  }
  return sequence;
}

double cosech(double argument) {
  constexpr double negligible = 90;  // e^-90 is below the square of round-off
  return std::abs(argument) > negligible ? 0 : 1 / std::sinh(argument);
}

/// theta = T tau by the trapezoidal rule on alternate points, spectrally accurate for the principal value.
MatrixXd alternate_point_conjugate(const LineNodes& nodes, const VectorXd& stretch, double spacing) {
  const Index count = stretch.size();
  std::vector<long double> potential;
  for (Index i = 0; i < count; ++i) potential.push_back(nodes.potential(static_cast<double>(i) * spacing));
  const auto phi = [&](Index i) { return potential[static_cast<std::size_t>(i)]; };
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index i = (j + 1) % 2; i < j; i += 2) {
      // Differences in extended precision: under a steep crest they are many orders below phi far away.
      const double behind = cosech(static_cast<double>(phi(i) - phi(j)) * pi / 2);
      const double ahead = cosech(static_cast<double>(phi(i) + phi(j)) * pi / 2);
      matrix(i, j) = spacing * stretch[j] * (behind + ahead);
      matrix(j, i) = i > 0 ? spacing * stretch[i] * (ahead - behind) : -spacing * stretch[0] * behind;
    }
  }
  matrix.row(0).setZero();
  return matrix;
}

/// theta = T tau by Fourier series with the symbol -i tanh(k), on equal steps of any size: long waves.
Extended fourier_conjugate_sequence(Index count, long double step) {
  const Index intervals = count - 1;
  const Extended angle = Extended::LinSpaced(2 * intervals, 0, 2 * intervals - 1) *
                         (std::numbers::pi_v<long double> / static_cast<long double>(intervals));
  const Extended sine = angle.array().sin();
  const Extended symbol = (angle.head(intervals) / step).array().tanh() / static_cast<long double>(intervals);
  Extended sequence = Extended::Zero(2 * count);
  for (Index m = 1; m < 2 * count; ++m) {
    for (Index k = 1; k < intervals; ++k) sequence[m] += symbol[k] * sine[(m * k) % (2 * intervals)];
  }
  return sequence;
}

/// Root kappa of tan(kappa)/kappa = F^2 in (0, pi/2): the tail decays like exp(-kappa x).
double solitary_decay_rate(double froude_squared) {
  constexpr int digits = 50;  // the last step of Newton's method doubles them
  return boost::math::tools::newton_raphson_iterate(
      [froude_squared](double kappa) {
        return std::pair(std::sin(kappa) - froude_squared * kappa * std::cos(kappa),
                         std::cos(kappa) * (1 - froude_squared) + froude_squared * kappa * std::sin(kappa));
      },
      std::min(1.2, std::sqrt(3 * (froude_squared - 1))), 0.0, pi / 2, digits);
}

/// @param tail  the wave is followed until it has decayed by exp(-tail)
SolitarySolution make_grid(double froude_squared, double crest_speed, double spacing, double clustering, double tail) {
  const double decay = solitary_decay_rate(froude_squared);
  // The nearest singularity lies q^3 F^2 above the crest; below a ~ 0.07 the wave is long and needs no cluster.
  constexpr double long_wave = 0.45;
  const bool clustered = decay > long_wave;
  const double rate = clustered ? 0.8 : 1.1 * decay;
  const double width = clustered ? std::min(0.9, clustering * rate * std::pow(crest_speed, 3) * froude_squared) : 1;
  const double longest = rate * std::max(tail / decay, clustered ? 1.25 * tail : 0) - std::log(width);
  SolitarySolution grid{.nodes = LineNodes(width, rate), .spacing = spacing};
  const auto count = static_cast<Index>(std::ceil(longest / spacing)) + 1;
  grid.potential.resize(count);
  grid.stretch.resize(count);
  for (Index j = 0; j < count; ++j) {
    const double s = static_cast<double>(j) * spacing;
    grid.potential[j] = static_cast<double>(grid.nodes.potential(s));
    grid.stretch[j] = grid.nodes.stretch(s);
  }
  return grid;
}

/// Unknowns y_0..y_N, F^2; equations: the crest, the streamline at j = 1..N, y_N = 0.
///
/// The residual is evaluated with extended precision: dy/dphi and theta of a long wave balance up to the square of its
/// amplitude, so that rounding is divided by it.
class SolitaryEquations {
 public:
  SolitaryEquations(const SolitarySolution& grid, WaveCrest crest)
      : stretch_(grid.stretch),
        slope_(derivative_sequence(grid.stretch.size(), grid.spacing)),
        derivative_(folded(slope_)),
        crest_(crest) {
    if (grid.nodes.uniform()) {
      long_wave_ = fourier_conjugate_sequence(
          grid.stretch.size(), static_cast<long double>(grid.spacing) * static_cast<long double>(grid.stretch[0]));
      conjugate_ = folded(*long_wave_);
    } else {
      conjugate_ = alternate_point_conjugate(grid.nodes, grid.stretch, grid.spacing);
    }
  }

  [[nodiscard]] bool admissible(const VectorXd& unknowns) const {
    const Index count = stretch_.size();
    return unknowns[count] > 0 && 2 * unknowns.head(count).maxCoeff() < unknowns[count];
  }

  [[nodiscard]] VectorXd inclination(const VectorXd& unknowns) const {
    return conjugate(log_speed(unknowns)).cast<double>();
  }

  [[nodiscard]] VectorXd residual(const VectorXd& unknowns) const {
    const Index count = stretch_.size();
    const Extended elevation = unknowns.head(count).cast<long double>();
    const Extended tau = log_speed(unknowns);
    const Extended theta = conjugate(tau);
    const Extended climb = stretch_.cast<long double>().array() * theta.array().sin() * (-tau.array()).exp();
    VectorXd result(count + 1);
    result.head(count) = (convolve(slope_, elevation) - climb).cast<double>();
    result[0] = crest_.amplitude ? unknowns[0] - *crest_.amplitude
                                 : unknowns[0] - 0.5 * unknowns[count] * (1 - *crest_.speed) * (1 + *crest_.speed);
    result[count] = unknowns[count - 1];
    return result;
  }

  void jacobian(const VectorXd& unknowns, MatrixXd& matrix) const {
    const Index count = stretch_.size();
    const double froude_squared = unknowns[count];
    const VectorXd tau = log_speed(unknowns).cast<double>();
    const VectorXd theta = conjugate_ * tau;
    const VectorXd inverse_speed = (-tau.array()).exp();
    const VectorXd along = stretch_.array() * theta.array().cos() * inverse_speed.array();
    const VectorXd across = stretch_.array() * theta.array().sin() * inverse_speed.array();
    const VectorXd tau_y = -inverse_speed.array().square() / froude_squared;
    const VectorXd tau_f = unknowns.head(count).array() * inverse_speed.array().square() / std::pow(froude_squared, 2);
    matrix.setZero(count + 1, count + 1);
    for (Index j = 0; j < count; ++j) {
      matrix.col(j).head(count) = derivative_.col(j) - tau_y[j] * along.cwiseProduct(conjugate_.col(j));
      matrix(j, j) += across[j] * tau_y[j];
    }
    matrix.col(count).head(count) = across.cwiseProduct(tau_f) - along.cwiseProduct(conjugate_ * tau_f);
    matrix.row(0).setZero();
    matrix(0, 0) = 1;
    if (crest_.speed) matrix(0, count) = -0.5 * (1 - *crest_.speed) * (1 + *crest_.speed);
    matrix(count, count - 1) = 1;
  }

 private:
  [[nodiscard]] Extended log_speed(const VectorXd& unknowns) const {
    const Index count = stretch_.size();
    const Extended head = unknowns.head(count).cast<long double>() * (-2 / static_cast<long double>(unknowns[count]));
    return head.array().log1p() / 2;
  }
  [[nodiscard]] Extended conjugate(const Extended& tau) const {
    return long_wave_ ? convolve(*long_wave_, tau) : Extended(conjugate_.cast<long double>() * tau);
  }

  VectorXd stretch_;
  Extended slope_;
  MatrixXd derivative_;
  std::optional<Extended> long_wave_;  ///< sequence of T on equal steps
  MatrixXd conjugate_;                 ///< T
  WaveCrest crest_;
};

/// The elevation of a solution at the nodes of another grid, scaled to another crest.
VectorXd elevation_on(const SolitarySolution& grid, const SolitarySolution& from, double crest) {
  const VectorXd none = VectorXd::Zero(from.count());
  return transfer(from, SincInterpolation(from.spacing, from.values, none, none), grid, crest);
}

double crest_speed_of(const SolitarySolution& wave) {
  return std::sqrt(1 - 2 * wave.values[0] / wave.speed_squared);
}

/// Continuation on coarse nodes, then one solution on fine nodes. Throws std::invalid_argument above the limiting wave.
SolitarySolution solve_solitary_wave(WaveCrest crest, Resolution resolution) {
  constexpr double coarse_spacing = 0.3;
  constexpr double coarse_tail = 14;
  constexpr double fine_spacing = 0.09;
  constexpr double fine_tail = 40;
  constexpr double step = 0.9;
  constexpr double least_speed = 2e-4;
  // Step 1: Rayleigh's wave, at most 0.3 high, corrected on coarse nodes.
  const double target =
      crest.amplitude ? *crest.amplitude : std::max(1e-3, (1 - *crest.speed) * (1 + *crest.speed) / 2);
  const double start = std::min(0.3, target);
  double froude_squared = 1 + start;
  SolitarySolution grid =
      make_grid(froude_squared, std::sqrt(1 - 2 * start / froude_squared), coarse_spacing, 1, coarse_tail);
  const double steepness = std::sqrt(0.75 * start / (1 + start));
  const VectorXd rayleigh = start * (steepness * grid.potential.array()).cosh().square().inverse();
  SolitarySolution wave = solve_on<SolitaryEquations>(grid, {start, {}}, rayleigh, froude_squared);
  // Step 2: towards the limiting wave, in the speed at the crest.
  const auto reached = [&] {
    return crest.amplitude ? wave.values[0] >= *crest.amplitude * (1 - 1e-12)
                           : crest_speed_of(wave) <= *crest.speed * (1 + 1e-4);
  };
  while (!reached()) {
    const double speed = std::max(step * crest_speed_of(wave), crest.speed.value_or(0));
    require_that(speed >= least_speed && wave.correction < 1e-4,
                 "amplitude/depth = {:.17g} is above the limiting solitary wave: the last wave that converged has "
                 "{:.8g}, with the speed {:.3g} c at its crest",
                 target, wave.values[0], crest_speed_of(wave));
    grid = make_grid(wave.speed_squared, speed, coarse_spacing, 1, coarse_tail);
    const double height = 0.5 * wave.speed_squared * (1 - speed * speed);
    wave = solve_on<SolitaryEquations>(grid, {{}, speed}, elevation_on(grid, wave, height), wave.speed_squared);
  }
  if (crest.amplitude) {
    auto close =
        solve_on<SolitaryEquations>(grid, crest, elevation_on(grid, wave, *crest.amplitude), wave.speed_squared);
    if (close.correction < 1e-4) wave = std::move(close);
  }
  // Step 3: the wave asked for on fine nodes.
  const double height = crest.amplitude ? *crest.amplitude : wave.values[0];
  const double speed = std::sqrt(std::max(1 - 2 * height / wave.speed_squared, least_speed * least_speed));
  grid = make_grid(wave.speed_squared, crest.speed.value_or(speed), fine_spacing / resolution.refinement,
                   resolution.clustering, fine_tail);
  wave = solve_on<SolitaryEquations>(grid, crest, elevation_on(grid, wave, height), wave.speed_squared);
  require_that(wave.correction < 1e-9,
               "amplitude/depth = {:.17g}: Newton's method stopped at a correction of {:.1e}; lower the amplitude or "
               "raise the resolution",
               target, wave.correction);
  return wave;
}

constexpr double kernel_reach = 12.5;  // periods p from where the kernel 1/sinh(pi z/p) is below round-off

}  // namespace

SolitarySurface::SolitarySurface(WaveCrest crest, Resolution resolution)
    : SolitarySurface(solve_solitary_wave(crest, resolution)) {}

SolitarySurface::SolitarySurface(Solution solution)
    : ConformalSurface(std::sqrt(solution.speed_squared), solution.spacing, std::numeric_limits<double>::infinity(), "",
                       "/depth"),
      solution_(std::move(solution)),
      crest_speed_(crest_speed_of(solution_)),
      decay_rate_(solitary_decay_rate(solution_.speed_squared)) {
  const auto& [nodes, spacing, depth, potential, stretch, elevation, theta, froude_squared, correction] = solution_;
  elevation_ = elevation;
  const Index count = elevation.size();
  std::vector<double> sine_integral;  // Si(pi k)/pi
  for (Index k = 0; k < 2 * count; ++k) sine_integral.push_back(gsl_sf_Si(pi * static_cast<double>(k)) / pi);
  const auto si = [&](Index k) {
    return k < 0 ? -sine_integral[static_cast<std::size_t>(-k)] : sine_integral[static_cast<std::size_t>(k)];
  };
  const VectorXd tau = 0.5 * (-2 / froude_squared * elevation.array()).log1p();
  const VectorXd inverse_speed = (-tau.array()).exp();
  // dX/ds = (cos(theta)/q - 1) dphi/ds, dy/ds = sin(theta)/q dphi/ds.
  const VectorXd displacement_rate = stretch.array() * ((-tau.array()).unaryExpr([](double t) {
                                       return std::expm1(t);
                                     }) - 2 * inverse_speed.array() * (0.5 * theta.array()).sin().square());
  const VectorXd climb = stretch.array() * theta.array().sin() * inverse_speed.array();
  VectorXd displacement = VectorXd::Zero(count);
  for (Index i = 1; i < count; ++i) {
    double sum = displacement_rate[0] * si(i);
    for (Index j = 1; j < count; ++j) sum += displacement_rate[j] * (si(i - j) + si(i + j));
    displacement[i] = spacing * sum;
  }
  end_displacement_ = spacing * (displacement_rate.sum() - 0.5 * displacement_rate[0]);
  position_ = potential + displacement;
  VectorXd decaying = displacement;
  for (Index i = 0; i < count; ++i) {
    decaying[i] -= end_displacement_ * std::tanh(0.5 * static_cast<double>(i) * spacing);
  }
  interpolation_ = SincInterpolation(spacing, elevation, decaying, displacement_rate);
  const VectorXd advance = stretch + displacement_rate;
  const auto line_integral = [&](const VectorXd& even) { return 2 * spacing * (even.sum() - 0.5 * even[0]); };
  integrals_.mass = line_integral(elevation.cwiseProduct(advance));
  integrals_.potential_energy = 0.5 * line_integral(elevation.cwiseProduct(elevation).cwiseProduct(advance));
  integrals_.kinetic_energy = -0.5 * froude_squared * line_integral(displacement.cwiseProduct(climb));
  integrals_.circulation = 2 * speed_ * end_displacement_;
  // Poles of the kernel at z + i p must stay outside the wave and its image, 2 (1 + a) < 3.7 high.
  kernel_period_ = std::max(6.0, 3 / decay_rate_);
  end_ = position_[count - 1];
  reach_ = kernel_reach * kernel_period_;
  for (Index j = 0; j < count; ++j) {
    add_to_contour({position_[j], elevation[j]}, 0.5 * std::log1p(-2 / froude_squared * elevation[j]), theta[j],
                   (j == 0 ? 0.5 : 1.0) * stretch[j]);
  }
  for (Index j = count; contour_.back() < end_ + reach_; ++j) {
    const double s = static_cast<double>(j) * spacing;
    add_to_contour({static_cast<double>(nodes.potential(s)) + end_displacement_, 0}, 0, 0, nodes.stretch(s));
  }
}

std::complex<double> SolitarySurface::pole(std::complex<double> z) const {
  const Complex root = std::sinh((z + Complex(0, 1)) * (pi / kernel_period_));
  return root * root;
}

SolitarySurface::Point SolitarySurface::point(double label) const {
  const SurfaceSample sample = interpolation_.at(label);
  const double displacement = end_displacement_ * std::tanh(0.5 * label) + sample.displacement;
  return {label, static_cast<double>(solution_.nodes.potential(label)) + displacement, displacement, sample.elevation,
          solution_.nodes.stretch(label) + sample.stretch};
}

double SolitarySurface::potential(double x) const {
  const double distance = std::abs(x);
  return std::copysign(speed_ * (distance >= end_ ? end_displacement_ : find(distance).displacement), x);
}

double SolitarySurface::half_width() const {
  const double last = static_cast<double>(position_.size() - 1) * solution_.spacing;
  return point(root([&](double label) { return point(label).elevation - 0.5 * crest(); }, 0, last)).x;
}

double SolitarySurface::maximum_slope() const {
  const VectorXd none = VectorXd::Zero(position_.size());
  return steepest(solution_.inclination, SincInterpolation(solution_.spacing, none, solution_.inclination, none));
}

namespace {

std::shared_ptr<const SolitarySurface> solved(WaveCrest crest, double depth, double gravity, Resolution resolution) {
  require_all_positive({{"depth", depth}, {"gravity", gravity}});
  require_resolution(resolution);
  if (crest.amplitude) require_finite("amplitude", depth * *crest.amplitude);
  if (crest.amplitude) require_within("amplitude/depth", *crest.amplitude, 0.001, 0.8331);
  if (crest.speed) require_within("crest_speed", *crest.speed, 3e-4, 0.999);
  return std::make_shared<const SolitarySurface>(crest, resolution);
}

}  // namespace

SolitaryWave::SolitaryWave(WaveCrest crest, double depth, double gravity, Resolution resolution)
    : ScaledWave(solved(crest, depth, gravity, resolution), 1 / depth, gravity), depth_(depth) {}

SolitaryWave::SolitaryWave(double amplitude, double depth, double gravity, Resolution resolution)
    : SolitaryWave(WaveCrest{amplitude / depth, {}}, depth, gravity, resolution) {}

SolitaryWave SolitaryWave::from_crest_speed(double crest_speed, double depth, double gravity, Resolution resolution) {
  return {WaveCrest{{}, crest_speed}, depth, gravity, resolution};
}

double SolitaryWave::uncertainty() const {
  // Long waves balance up to the square of their amplitude; q^2 = 1 - 2 y/F^2 is a difference near the limiting wave,
  // and its rounding is divided by 2 q.
  constexpr double rounding = 1e-14;
  const double small = 0.1 / std::min(0.1, surface_->crest());
  const double steep = std::max(1.0, 0.5 / crest_speed());
  return rounding * small * steep;
}

SelfTest SolitaryWave::self_test() const {
  const auto& integrals = surface_->integrals();
  const double f = froude();
  const double impulse = f * integrals.mass;
  const double sum_limit = 5 * uncertainty();
  const std::string sum_reason = "sums of about 500 terms of values good to the stated uncertainty";
  const double twice_kinetic = 2 * integrals.kinetic_energy;
  // I - C = O(a^(3/2)) is a difference of terms O(a^(1/2)).
  return {{"2 T = F (I - C)", std::abs(twice_kinetic - f * (impulse - integrals.circulation)) / twice_kinetic,
           sum_limit * std::max(1.0, impulse / twice_kinetic), sum_reason},
          {"3 V = (F^2 - 1) M", departure((f - 1) * (f + 1) * integrals.mass, 3 * integrals.potential_energy),
           sum_limit, sum_reason},
          {"volume flux through the crest section = c a", departure(section_flux(*surface_, -1), f * surface_->crest()),
           sum_limit, "280 Gauss points of velocities good to the stated uncertainty"}};
}

ExactSolution solitary_entry() {
  return Entry<SolitaryWave>{
      .name = "solitary",
      .title = "Solitary wave of the full Euler equations, with the velocities inside",
      .citation =
          "Longuet-Higgins & Fenton, On the mass, momentum, energy and circulation of a solitary wave II, Proc. R. "
          "Soc. A 340 (1974) 471; Hunter & Vanden-Broeck, Accurate computations for steep solitary waves, J. Fluid "
          "Mech. 136 (1983) 63; Dutykh & Clamond, Efficient computation of steady solitary gravity waves, Wave Motion "
          "51 (2014) 86",
      .formula =
          "theta(phi) = 1/2 PV int tau(phi')/sinh(pi (phi - phi')/2) dphi', y = F^2 (1 - q^2)/2, dy/dphi = "
          "sin(theta)/q, q = exp(tau); f = F (1 - dW/dz) inside by a quotient of Cauchy sums",
      .parameters = {{"amplitude", "m", 0.3, 1e-9, 1e6, "crest above still water, up to 0.8331 depth"},
                     depth_parameter(1, 1e6),
                     gravity_parameter()},
      .inputs = {position_x, height_y, time_t},
      .outputs = {surface_eta, velocity_u, velocity_v},
      .scalars = {{"speed", "m/s", "phase speed c", &SolitaryWave::speed},
                  {"F", "1", "c/sqrt(gravity depth)", &SolitaryWave::froude},
                  {"mass", "m^2", "int eta dx", &SolitaryWave::mass},
                  {"kinetic", "m^4/s^2", "kinetic energy, density 1", &SolitaryWave::kinetic_energy},
                  {"potential", "m^4/s^2", "potential energy, density 1", &SolitaryWave::potential_energy},
                  {"circulation", "m^2/s", "int u dx along the bottom", &SolitaryWave::circulation},
                  {"impulse", "m^3/s", "c times the mass", &SolitaryWave::impulse},
                  {"crest_velocity", "m/s", "horizontal velocity at the crest", &SolitaryWave::crest_velocity},
                  {"half_width", "m", "distance from the crest where eta is half the amplitude",
                   &SolitaryWave::half_width},
                  {"maximum_slope", "rad", "largest inclination of the surface", &SolitaryWave::maximum_slope}},
      .make = from<SolitaryWave>("amplitude", "depth", "gravity"),
      .row = wave_row<SolitaryWave>};
}

}  // namespace seiche::exact
