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
using Eigen::VectorXd;
using std::numbers::pi;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

double cosech(double argument) {
  constexpr double negligible = 90;  // e^-90 is below the square of round-off
  return std::abs(argument) > negligible ? 0 : 1 / std::sinh(argument);
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

/// On the nodes s_j = j spacing, j = 0..N, of functions that vanish beyond them. Folding the nodes s_j and -s_j leaves
/// one reciprocal per pair for all functions.
class SincInterpolation {
 public:
  SincInterpolation(double spacing, const VectorXd& elevation, const VectorXd& displacement, const VectorXd& stretch)
      : spacing_(spacing) {
    for (Index j = 0; j < elevation.size(); ++j) {
      const double sign = j % 2 == 0 ? 1 : -1;
      const double fold = j == 0 ? 0.5 : 1;
      elevation_.push_back(sign * fold * elevation[j]);
      displacement_.push_back(sign * static_cast<double>(j) * displacement[j]);
      stretch_.push_back(sign * fold * stretch[j]);
      position_.push_back(static_cast<double>(j));
    }
  }

  /// @param s  in [0, N spacing]
  [[nodiscard]] SurfaceSample operator()(double s) const {
    const double t = s / spacing_;
    const double nearest = std::round(t);
    const double offset = t - nearest;
    const double sign = std::fmod(nearest, 2) == 0 ? 1 : -1;
    if (std::abs(offset) < 1e-290) {
      const auto j = static_cast<std::size_t>(nearest);
      const double fold = sign * (j == 0 ? 2 : 1);
      return {fold * elevation_[j], j == 0 ? 0 : sign * displacement_[j] / nearest, fold * stretch_[j]};
    }
    double elevation = 0;
    double displacement = 0;
    double stretch = 0;
#pragma omp simd reduction(+ : elevation, displacement, stretch)
    for (std::size_t j = 0; j < position_.size(); ++j) {
      const double kernel = 1 / ((t - position_[j]) * (t + position_[j]));
      elevation += elevation_[j] * kernel;
      displacement += displacement_[j] * kernel;
      stretch += stretch_[j] * kernel;
    }
    const double factor = 2 * sign * std::sin(std::numbers::pi * offset) / std::numbers::pi;
    return {factor * t * elevation, factor * displacement, factor * t * stretch};
  }

 private:
  double spacing_;
  std::vector<double> elevation_, displacement_, stretch_, position_;
};

/// phi(s) = asinh(width sinh s)/rate: spacing ds/rate far away, geometric near phi = 0 for width << 1, uniform for
/// width = 1. Analytic in |Im s| < pi/2.
class LineNodes : public ConformalNodes {
 public:
  /// @param longest  the last node
  LineNodes(double width, double rate, double spacing, double longest)
      : ConformalNodes(false, 1), width_(width), rate_(rate) {
    place(static_cast<Index>(std::ceil(longest / spacing)) + 1, spacing);
  }

  [[nodiscard]] Node at(double s) const override {
    if (uniform()) return {static_cast<long double>(s) / rate_, 1 / rate_};
    const auto length = static_cast<long double>(s);
    if (s >= 100) return {(length + std::log(static_cast<long double>(width_))) / rate_, 1 / rate_};
    const double sinh = width_ * std::sinh(s);
    return {std::asinh(width_ * std::sinh(length)) / rate_,
            width_ * std::cosh(s) / (rate_ * std::sqrt(1 + sinh * sinh))};
  }
  [[nodiscard]] double label(double potential) const override {
    const double length = rate_ * potential;
    if (uniform()) return length;
    return length < 300 ? std::asinh(std::sinh(length) / width_) : length - std::log(width_);
  }
  /// By the sinc series.
  [[nodiscard]] Matrix derivative() const override {
    return folded([step = static_cast<long double>(spacing())](Index m) {
      return (m % 2 == 0 ? 1 : -1) / (step * static_cast<long double>(m));
    });
  }
  [[nodiscard]] Matrix conjugate() const override {
    if (!uniform()) return on_alternate_points([](double x) { return 0.5 * cosech(pi / 2 * x); });
    const auto step = static_cast<long double>(spacing()) * static_cast<long double>(stretch()[0]);
    const Extended sequence = fourier_conjugate_sequence(count(), step);
    return folded([&](Index m) { return sequence[m]; });
  }
  [[nodiscard]] Interpolation between(const VectorXd& elevation, const VectorXd& displacement,
                                      const VectorXd& stretch) const override {
    return SincInterpolation(spacing(), elevation, displacement, stretch);
  }

 private:
  [[nodiscard]] bool uniform() const { return width_ == 1; }

  double width_, rate_;
};

/// @param tail  the wave is followed until it has decayed by exp(-tail)
std::shared_ptr<const ConformalNodes> line_nodes(double froude_squared, double crest_speed, double spacing,
                                                 double clustering, double tail) {
  const double decay = solitary_decay_rate(froude_squared);
  // The nearest singularity lies q^3 F^2 above the crest; below a ~ 0.07 the wave is long and needs no cluster.
  constexpr double long_wave = 0.45;
  const bool clustered = decay > long_wave;
  const double rate = clustered ? 0.8 : 1.1 * decay;
  const double width = clustered ? std::min(0.9, clustering * rate * std::pow(crest_speed, 3) * froude_squared) : 1;
  const double longest = rate * std::max(tail / decay, clustered ? 1.25 * tail : 0) - std::log(width);
  return std::make_shared<const LineNodes>(width, rate, spacing, longest);
}

/// Continuation on coarse nodes, then one solution on fine nodes. Throws std::invalid_argument above the limiting wave.
ConformalSolution solve_solitary_wave(WaveCrest crest, Resolution resolution) {
  const double target = crest.height ? *crest.height : std::max(1e-3, (1 - *crest.speed) * (1 + *crest.speed) / 2);
  const WaveFamily family{.nodes =
                              [=](double froude_squared, double crest_speed, bool fine) {
                                return fine ? line_nodes(froude_squared, crest_speed, 0.09 / resolution.refinement,
                                                         resolution.clustering, 40)
                                            : line_nodes(froude_squared, crest_speed, 0.3, 1, 14);
                              },
                          .least_speed = 2e-4,
                          .limit = fmt::format("amplitude/depth = {:.17g} is above the limiting solitary wave", target),
                          .described = fmt::format("amplitude/depth = {:.17g}", target),
                          .share = 1};
  // Rayleigh's wave, at most 0.3 high, corrected on coarse nodes.
  const double start = std::min(0.3, target);
  const double froude_squared = 1 + start;
  const auto nodes = family.nodes(froude_squared, std::sqrt(1 - 2 * start / froude_squared), false);
  const double steepness = std::sqrt(0.75 * start / (1 + start));
  const VectorXd rayleigh = start * (steepness * nodes->potential().array()).cosh().square().inverse();
  const VectorXd tau = 0.5 * (-2 / froude_squared * rayleigh.array()).log1p();
  return refined(family, crest, approach(family, crest, solve_on(nodes, {start, {}}, tau, froude_squared)));
}

constexpr double kernel_reach = 12.5;  // periods p from where the kernel 1/sinh(pi z/p) is below round-off

std::shared_ptr<const SolitarySurface> solved(WaveCrest crest, double depth, double gravity, Resolution resolution) {
  require_all_positive({{"depth", depth}, {"gravity", gravity}});
  require_resolution(resolution);
  if (crest.height) require_finite("amplitude", depth * *crest.height);
  if (crest.height) require_within("amplitude/depth", *crest.height, 0.001, 0.8331);
  if (crest.speed) require_within("crest_speed", *crest.speed, 3e-4, 0.999);
  return std::make_shared<const SolitarySurface>(crest, resolution);
}

}  // namespace

SolitarySurface::SolitarySurface(WaveCrest crest, Resolution resolution)
    : SolitarySurface(solve_solitary_wave(crest, resolution)) {}

SolitarySurface::SolitarySurface(ConformalSolution solution)
    : ConformalSurface(std::move(solution), "", "/depth"), decay_rate_(solitary_decay_rate(solution_.speed_squared)) {
  const auto& [nodes, tau, theta, froude_squared, correction] = solution_;
  const double spacing = nodes->spacing();
  const VectorXd& stretch = nodes->stretch();
  const VectorXd elevation = -froude_squared / 2 * (2 * tau.array()).unaryExpr([](double t) { return std::expm1(t); });
  elevation_ = elevation;
  const Index count = elevation.size();
  std::vector<double> sine_integral;  // Si(pi k)/pi
  for (Index k = 0; k < 2 * count; ++k) sine_integral.push_back(gsl_sf_Si(pi * static_cast<double>(k)) / pi);
  const auto si = [&](Index k) {
    return k < 0 ? -sine_integral[static_cast<std::size_t>(-k)] : sine_integral[static_cast<std::size_t>(k)];
  };
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
  position_ = nodes->potential() + displacement;
  VectorXd decaying = displacement;
  for (Index i = 0; i < count; ++i) {
    decaying[i] -= end_displacement_ * std::tanh(0.5 * static_cast<double>(i) * spacing);
  }
  interpolation_ = nodes->between(elevation, decaying, displacement_rate);
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
  add_nodes_to_contour();
  for (Index j = count; contour_.back() < end_ + reach_; ++j) {
    const auto node = nodes->at(static_cast<double>(j) * spacing);
    add_to_contour({static_cast<double>(node.potential) + end_displacement_, 0}, 0, 0, node.stretch);
  }
}

std::complex<double> SolitarySurface::pole(std::complex<double> z) const {
  const Complex root = std::sinh((z + Complex(0, 1)) * (pi / kernel_period_));
  return root * root;
}

SolitarySurface::Point SolitarySurface::point(double label) const {
  const SurfaceSample sample = interpolation_(label);
  const auto node = solution_.nodes->at(label);
  const double displacement = end_displacement_ * std::tanh(0.5 * label) + sample.displacement;
  return {label, static_cast<double>(node.potential) + displacement, displacement, sample.elevation,
          node.stretch + sample.stretch};
}

double SolitarySurface::potential(double x) const {
  const double distance = std::abs(x);
  return std::copysign(speed_ * (distance >= end_ ? end_displacement_ : find(distance).displacement), x);
}

double SolitarySurface::half_width() const {
  const double last = static_cast<double>(position_.size() - 1) * solution_.nodes->spacing();
  return point(root([&](double label) { return point(label).elevation - 0.5 * crest(); }, 0, last)).x;
}

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
