#include "seiche/exact/stokes_wave.hpp"

#include <algorithm>

#include "seiche/exact/entry.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
using StokesSolution = StokesSurface::Solution;
/// s_j of so many nodes.
double label(Index j, Index count) {
  return pi * static_cast<double>(j) / static_cast<double>(count - 1);
}

constexpr double round_off_exponent = 38;  // e^-38 = 3e-17

/// d/ds of an even function on s_j = pi j/m, folded onto 0 <= j <= m; rows 1..m-1.
MatrixXd even_periodic_derivative(Index count) {
  const Index last = count - 1;
  const auto half_cotangent = [&](Index difference) {
    return 0.5 * (difference % 2 == 0 ? 1 : -1) /
           std::tan(0.5 * pi * static_cast<double>(difference) / static_cast<double>(last));
  };
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index i = 1; i < last; ++i) {
      if (i != j) matrix(i, j) += half_cotangent(i - j);
      if (j > 0 && j < last) matrix(i, j) += half_cotangent(i + j);
    }
  }
  return matrix;
}

/// Kernel of -i tanh(k d) on 2 pi periodic functions.
class PeriodicKernel {
 public:
  explicit PeriodicKernel(double depth) : depth_(depth) {
    if (depth >= shallow) {
      for (int k = 1; 2 * k * depth < round_off_exponent; ++k) correction_.push_back(4 / (std::exp(2 * k * depth) + 1));
    } else {
      images_ = static_cast<int>(std::ceil(round_off_exponent * depth / (pi * pi))) + 1;
    }
  }

  [[nodiscard]] double operator()(double x) const {
    if (depth_ >= shallow) {
      double sum = 1 / std::tan(0.5 * x);
      for (std::size_t k = 0; k < correction_.size(); ++k) {
        sum -= correction_[k] * std::sin(static_cast<double>(k + 1) * x);
      }
      return sum / (2 * pi);
    }
    const double nearest = x > pi ? x - 2 * pi : x;
    double sum = cosech(nearest);
    for (int n = 1; n <= images_; ++n) sum += cosech(nearest + 2 * pi * n) + cosech(nearest - 2 * pi * n);
    return sum / (2 * depth_);
  }

 private:
  static constexpr double shallow = 2.5;

  [[nodiscard]] double cosech(double x) const {
    const double argument = pi * x / (2 * depth_);
    return std::abs(argument) > 90 ? 0 : 1 / std::sinh(argument);
  }

  double depth_;
  std::vector<double> correction_;
  int images_ = 0;
};

StokesSolution make_grid(double speed_squared, double crest_speed, double depth, Resolution resolution) {
  // The nearest singularity lies q^3 c^2 above the crest.
  const double width = std::min(1.0, resolution.clustering * std::pow(crest_speed, 3) * speed_squared);
  StokesSolution grid{.nodes = PeriodicNodes(width), .depth = depth};
  const double quarter = grid.nodes.quarter_period();
  // Half the number of nodes: resolution of the surface, and steps below 0.15 depth for the kernel.
  const double half_count = std::max(56 * quarter / pi + 20, 2 * quarter / (0.15 * depth));
  const auto count = static_cast<Index>(std::ceil(resolution.refinement * half_count)) + 1;
  grid.spacing = pi / static_cast<double>(count - 1);
  grid.potential.resize(count);
  grid.stretch.resize(count);
  for (Index j = 0; j < count; ++j) {
    const auto node = grid.nodes.at(label(j, count));
    grid.potential[j] = static_cast<double>(node.potential);
    grid.stretch[j] = node.stretch;
  }
  return grid;
}

/// theta = T tau by the trapezoidal rule on alternate points; rows 1..m-1, theta vanishes at crest and trough.
MatrixXd periodic_conjugate(const StokesSolution& grid) {
  const Index count = grid.stretch.size();
  const Index last = count - 1;
  const double weight = 2 * pi / static_cast<double>(last);
  const PeriodicKernel kernel(grid.depth);
  std::vector<long double> phi;
  for (Index j = 0; j < count; ++j) phi.push_back(grid.nodes.at(label(j, count)).potential);
  const auto at = [&](Index j) { return phi[static_cast<std::size_t>(j)]; };
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index i = (j + 1) % 2; i < j; i += 2) {
      const double behind = kernel(static_cast<double>(at(j) - at(i)));
      const double ahead = i > 0 && j < last ? kernel(static_cast<double>(at(i) + at(j))) : 0;
      matrix(i, j) = weight * grid.stretch[j] * (ahead - behind);
      matrix(j, i) = weight * grid.stretch[i] * (ahead + behind);
    }
  }
  matrix.row(0).setZero();
  matrix.row(last).setZero();
  return matrix;
}

/// Unknowns tau_0..tau_m, c^2; equations: the crest, the surface at j = 1..m-1, the wavelength, no sawtooth.
class StokesEquations {
 public:
  StokesEquations(const StokesSolution& grid, WaveCrest crest)
      : stretch_(grid.stretch),
        derivative_(even_periodic_derivative(grid.stretch.size())),
        conjugate_(periodic_conjugate(grid)),
        weight_(VectorXd::Ones(grid.stretch.size())),
        crest_(crest) {
    weight_[0] = weight_[weight_.size() - 1] = 0.5;
    weight_ /= static_cast<double>(weight_.size() - 1);
  }

  [[nodiscard]] bool admissible(const VectorXd& unknowns) const {
    const Index count = stretch_.size();
    return unknowns[count] > 0 && unknowns.head(count).lpNorm<Eigen::Infinity>() < 12;
  }

  [[nodiscard]] VectorXd inclination(const VectorXd& unknowns) const {
    return conjugate_ * unknowns.head(stretch_.size());
  }

  [[nodiscard]] VectorXd residual(const VectorXd& unknowns) const {
    const Index count = stretch_.size();
    const Index last = count - 1;
    const VectorXd tau = unknowns.head(count);
    const double speed_squared = unknowns[count];
    const VectorXd theta = conjugate_ * tau;
    VectorXd result(count + 1);
    result.head(count) = speed_squared / 2 * (derivative_ * squares(tau));
    result.head(count).array() += stretch_.array() * theta.array().sin() * (-tau.array()).exp();
    result[0] = crest_.amplitude
                    ? speed_squared * (std::expm1(2 * tau[last]) - std::expm1(2 * tau[0])) / 2 - 2 * *crest_.amplitude
                    : tau[0] - std::log(*crest_.speed);
    // cos(theta)/q - 1
    const VectorXd excess = (-tau.array()).unaryExpr([](double t) { return std::expm1(t); }) -
                            2 * (0.5 * theta.array()).sin().square() * (-tau.array()).exp();
    result[last] = weight_.cwiseProduct(stretch_).dot(excess);
    result[count] = sawtooth().dot(tau);
    return result;
  }

  void jacobian(const VectorXd& unknowns, MatrixXd& matrix) const {
    const Index count = stretch_.size();
    const Index last = count - 1;
    const VectorXd tau = unknowns.head(count);
    const double speed_squared = unknowns[count];
    const VectorXd theta = conjugate_ * tau;
    const VectorXd inverse_speed = (-tau.array()).exp();
    const VectorXd along = stretch_.array() * theta.array().cos() * inverse_speed.array();
    const VectorXd across = stretch_.array() * theta.array().sin() * inverse_speed.array();
    matrix.setZero(count + 1, count + 1);
    for (Index j = 0; j < count; ++j) {
      matrix.col(j).head(count) =
          speed_squared * std::exp(2 * tau[j]) * derivative_.col(j) + along.cwiseProduct(conjugate_.col(j));
      matrix(j, j) -= across[j];
    }
    matrix.col(count).head(count) = derivative_ * squares(tau) / 2;
    matrix.row(0).setZero();
    if (crest_.amplitude) {
      matrix(0, 0) = -speed_squared * std::exp(2 * tau[0]);
      matrix(0, last) = speed_squared * std::exp(2 * tau[last]);
      matrix(0, count) = (std::expm1(2 * tau[last]) - std::expm1(2 * tau[0])) / 2;
    } else {
      matrix(0, 0) = 1;
    }
    matrix.row(last).setZero();
    matrix.row(last).head(count) =
        -weight_.cwiseProduct(along).transpose() - weight_.cwiseProduct(across).transpose() * conjugate_;
    matrix.row(count).head(count) = sawtooth().transpose();
  }

 private:
  /// q^2 - 1
  static VectorXd squares(const VectorXd& tau) {
    return (2 * tau.array()).unaryExpr([](double t) { return std::expm1(t); });
  }
  [[nodiscard]] VectorXd sawtooth() const {
    VectorXd signs = weight_;
    for (Index j = 1; j < signs.size(); j += 2) signs[j] = -signs[j];
    return signs;
  }

  VectorXd stretch_;
  MatrixXd derivative_;
  MatrixXd conjugate_;
  VectorXd weight_;
  WaveCrest crest_;
};

double amplitude_of(const StokesSolution& wave) {
  return 0.25 * wave.speed_squared * (std::expm1(2 * wave.values[wave.count() - 1]) - std::expm1(2 * wave.values[0]));
}

/// tau of a solution at the nodes of another grid, scaled to another crest.
VectorXd tau_on(const StokesSolution& grid, const StokesSolution& from, double crest_log_speed) {
  const VectorXd none = VectorXd::Zero(from.count());
  return transfer(from, TrigonometricInterpolation(from.values, none, none), grid, crest_log_speed);
}

/// Continuation to the crest asked for on coarser nodes.
StokesSolution approach(WaveCrest crest, double depth, Resolution resolution) {
  constexpr double step = 0.105;  // q falls by a tenth
  constexpr double least_speed = 1.2e-3;
  const double linear_speed_squared = std::tanh(depth);
  const double wanted = crest.amplitude ? *crest.amplitude / linear_speed_squared : -std::log(*crest.speed);
  const double start = std::min({0.05, 0.5 * depth * depth, 0.8 * wanted});
  const Resolution coarse{0.5 * resolution.refinement, resolution.clustering};
  StokesSolution grid = make_grid(linear_speed_squared, std::exp(-start), depth, coarse);
  StokesSolution wave = solve_on<StokesEquations>(grid, {{}, std::exp(-start)}, -start * grid.potential.array().cos(),
                                                  linear_speed_squared);
  const auto reached = [&] {
    return crest.amplitude ? amplitude_of(wave) >= *crest.amplitude * (1 - 1e-9)
                           : wave.values[0] <= std::log(*crest.speed) + 1e-12;
  };
  StokesSolution last = wave;
  while (!reached()) {
    const double slope = std::min(-1.6 * wave.values[0], step - wave.values[0]);
    const double speed = std::max(std::exp(-slope), crest.speed.value_or(0));
    const bool converged = wave.correction < 1e-6;
    // a = c^2 (q_trough^2 - q^2)/4: near the limiting wave no more than about c^2 q^2/4 is left.
    const double left = wave.speed_squared * std::exp(2 * wave.values[0]);
    const bool beyond =
        crest.amplitude && wave.values[0] < std::log(0.1) && *crest.amplitude > amplitude_of(wave) + left;
    if (converged) last = wave;
    require_that(speed >= least_speed && converged && !beyond,
                 "k amplitude = {:.17g} is above the limiting Stokes wave for k times conformal depth = {:g}: the last "
                 "wave that "
                 "converged has {:.8g}, with the speed {:.3g} c at its crest",
                 wanted * (crest.amplitude ? linear_speed_squared : 1), depth, amplitude_of(last),
                 std::exp(last.values[0]));
    grid = make_grid(wave.speed_squared, speed, depth, coarse);
    wave = solve_on<StokesEquations>(grid, {{}, speed}, tau_on(grid, wave, std::log(speed)), wave.speed_squared);
  }
  if (!crest.amplitude) return wave;
  StokesSolution close = solve_on<StokesEquations>(grid, crest, wave.values, wave.speed_squared);
  return close.correction < 1e-6 ? close : wave;
}

/// Continuation in the crest's speed from a linear wave, or from `nearby` where one is given. Throws
/// std::invalid_argument above the limiting wave.
StokesSolution solve_stokes_wave(WaveCrest crest, double conformal_depth, Resolution resolution,
                                 const StokesSolution* nearby = nullptr) {
  const StokesSolution close = nearby ? *nearby : approach(crest, conformal_depth, resolution);
  const StokesSolution grid = make_grid(close.speed_squared, std::exp(close.values[0]), conformal_depth, resolution);
  StokesSolution wave =
      solve_on<StokesEquations>(grid, crest, tau_on(grid, close, close.values[0]), close.speed_squared);
  require_that(wave.correction < 1e-8,
               "k amplitude = {:.17g}, k depth = {:g}: Newton's method stopped at a correction of {:.1e}; lower the "
               "amplitude or raise the resolution",
               crest.amplitude.value_or(amplitude_of(wave)), conformal_depth, wave.correction);
  return wave;
}

/// Integral from 0 of an even periodic function on s_j = pi j/m, without the part of its mean.
VectorXd odd_integral(const VectorXd& even) {
  const Index last = even.size() - 1;
  const auto angle = [&](Index product) {
    return pi * static_cast<double>(product % (2 * last)) / static_cast<double>(last);
  };
  VectorXd result = VectorXd::Zero(even.size());
  for (Index k = 1; k < last; ++k) {
    double coefficient = 0.5 * (even[0] + (k % 2 == 0 ? 1 : -1) * even[last]);
    for (Index j = 1; j < last; ++j) coefficient += even[j] * std::cos(angle(j * k));
    coefficient *= 2 / (static_cast<double>(last) * static_cast<double>(k));
    for (Index j = 1; j < last; ++j) result[j] += coefficient * std::sin(angle(j * k));
  }
  return result;
}

}  // namespace

StokesSurface::StokesSurface(Solution solution)
    : ConformalSurface(std::sqrt(solution.speed_squared), solution.spacing, pi, "k ", ""),
      solution_(std::move(solution)) {
  const auto& [nodes, spacing, depth, potential, stretch, tau, theta, speed_squared, correction] = solution_;
  const Index count = tau.size();
  const Index last = count - 1;
  const auto mean = [&](const VectorXd& even) {
    return (even.sum() - 0.5 * (even[0] + even[last])) / static_cast<double>(last);
  };
  const VectorXd inverse_speed = (-tau.array()).exp();
  const VectorXd advance = stretch.array() * theta.array().cos() * inverse_speed.array();
  const VectorXd climb = stretch.array() * theta.array().sin() * inverse_speed.array();
  const VectorXd head = -0.5 * speed_squared * (2 * tau.array()).unaryExpr([](double t) { return std::expm1(t); });
  const double mean_head = mean(head.cwiseProduct(advance));
  elevation_ = head.array() - mean_head;
  bernoulli_ = 0.5 * speed_squared - mean_head;
  const VectorXd periodic = odd_integral(advance);
  position_.resize(count);
  for (Index j = 0; j < count; ++j) position_[j] = label(j, count) + periodic[j];
  interpolation_ = TrigonometricInterpolation(elevation_, periodic, advance);
  const double conformal_mean = mean(elevation_.cwiseProduct(stretch));
  depth_ = depth - conformal_mean;
  integrals_.impulse = -speed_ * conformal_mean;
  integrals_.kinetic_energy = -0.5 * speed_squared * mean((position_ - potential).cwiseProduct(climb));
  integrals_.potential_energy = 0.5 * mean(elevation_.cwiseProduct(elevation_).cwiseProduct(advance));
  for (Index j = 0; j <= last; ++j) {
    add_to_contour({position_[j], elevation_[j]}, tau[j], theta[j], (j == 0 || j == last ? 0.5 : 1) * stretch[j]);
  }
}

StokesSurface StokesSurface::with_mean_depth(WaveCrest crest, double mean_depth, Resolution resolution) {
  if (std::isinf(mean_depth)) return StokesSurface(solve_stokes_wave(crest, mean_depth, resolution));
  double depth = mean_depth;
  StokesSurface wave(solve_stokes_wave(crest, depth, resolution));
  double excess = wave.depth() - mean_depth;
  double slope = 1;
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps && std::abs(excess) > 2e-16 * mean_depth; ++step) {
    const double change = -excess / slope;
    const StokesSolution nearby = wave.solution();
    wave = StokesSurface(solve_stokes_wave(crest, depth + change, resolution, &nearby));
    depth += change;
    const double next = wave.depth() - mean_depth;
    if (std::abs(next) >= 0.5 * std::abs(excess)) break;
    slope = (next - excess) / change;
    excess = next;
  }
  return wave;
}

std::complex<double> StokesSurface::pole(std::complex<double> z) const {
  if (!bottom_matters()) return std::exp(Complex(0, 1) * z);
  const Complex root = std::sin(0.5 * (z + Complex(0, depth_)));
  return root * root;
}

StokesSurface::Point StokesSurface::point(double label) const {
  const SurfaceSample sample = interpolation_.at(label);
  return {label, label + sample.displacement, sample.displacement, sample.elevation, sample.stretch};
}

double StokesSurface::potential(double x) const {
  const double place = reduced(x);
  const Point surface = find(std::abs(place));
  return std::copysign(speed_ * (surface.x - static_cast<double>(solution_.nodes.at(surface.label).potential)), place);
}

double StokesSurface::maximum_slope() const {
  const VectorXd none = VectorXd::Zero(position_.size());
  return steepest(solution_.inclination, TrigonometricInterpolation(none, solution_.inclination, none));
}

namespace {

/// Wavenumber of a medium in which the wave exists.
double checked_wavenumber(double wavelength, double depth, const char* depth_name, double gravity,
                          Resolution resolution) {
  require_all_positive({{"wavelength", wavelength}, {"gravity", gravity}});
  require_resolution(resolution);
  if (!(depth > 0)) require_positive(depth_name, depth);
  const double wavenumber = 2 * pi / wavelength;
  constexpr double shallowest = 0.2;
  require_that(wavenumber * depth >= shallowest,
               "k {} = {:.17g}, k = 2 pi/wavelength, is out of range: must be at least {}; the crests of longer waves "
               "are solitary waves: use SolitaryWave",
               depth_name, wavenumber * depth, shallowest);
  return wavenumber;
}

double checked_amplitude(double amplitude, double wavenumber) {
  require_positive("amplitude", amplitude);
  require_within("k amplitude", wavenumber * amplitude, 1e-4, 0.4432);  // the limiting deep wave has 0.44316
  return wavenumber * amplitude;
}

}  // namespace

StokesWave::StokesWave(double amplitude, double wavelength, double mean_depth, double gravity, Resolution resolution)
    : StokesWave(
          [&] {
            const double k = checked_wavenumber(wavelength, mean_depth, "mean_depth", gravity, resolution);
            return StokesSurface::with_mean_depth({checked_amplitude(amplitude, k), {}}, k * mean_depth, resolution);
          }(),
          2 * pi / wavelength, gravity) {}

StokesWave StokesWave::from_conformal_depth(double amplitude, double wavelength, double conformal_depth, double gravity,
                                            Resolution resolution) {
  const double k = checked_wavenumber(wavelength, conformal_depth, "conformal_depth", gravity, resolution);
  const WaveCrest crest{checked_amplitude(amplitude, k), {}};
  return {StokesSurface(solve_stokes_wave(crest, k * conformal_depth, resolution)), k, gravity};
}

StokesWave StokesWave::from_crest_speed(double crest_speed, double wavelength, double conformal_depth, double gravity,
                                        Resolution resolution) {
  const double k = checked_wavenumber(wavelength, conformal_depth, "conformal_depth", gravity, resolution);
  require_within("crest_speed", crest_speed, 0.0015, 0.9999);
  return {StokesSurface(solve_stokes_wave({{}, crest_speed}, k * conformal_depth, resolution)), k, gravity};
}

double StokesWave::uncertainty() const {
  // q^2 = 2 (B - y)/c^2 is a difference near the limiting wave: its rounding is divided by 2 q.
  constexpr double rounding = 1e-14;
  const double steep = std::max(1.0, 0.5 / crest_speed());
  const double gentle = std::max(1.0, 0.01 / surface_->crest());  // y is a difference of Bernoulli's constant
  return rounding * steep * gentle;
}

SelfTest StokesWave::self_test() const {
  const auto& integrals = surface_->integrals();
  const double c = surface_->speed();
  const double limit = 5 * uncertainty();
  const double scale = std::max(2 * integrals.kinetic_energy, 1e-3);
  const double deepest = std::min(surface_->depth(), 40.0);
  const double crest = section_flux(*surface_, -deepest);
  constexpr int points = 64;
  const double level = std::max(0.5 * (surface_->trough() - deepest), -1.0 + surface_->trough());
  double mean = 0;
  for (int j = 0; j < points; ++j) mean += surface_->velocity(2 * pi * j / points, level).u / points;
  return {{"2 T = c I", std::abs(2 * integrals.kinetic_energy - c * integrals.impulse) / scale, limit,
           "means over the nodes of values good to the stated uncertainty; relative to 2 T or 0.001"},
          {"volume flux through the crest section = c eta + I",
           std::abs(crest - c * surface_->crest() - integrals.impulse) / crest, limit,
           "280 Gauss points of velocities good to the stated uncertainty"},
          {"mean Eulerian velocity below the troughs = 0",
           std::abs(mean) / (c * -std::expm1(surface_->solution().values[0])), limit,
           "64 equally spaced velocities, relative to that at the crest"}};
}

ExactSolution stokes_entry() {
  return Entry<StokesWave>{
      .name = "stokes",
      .title = "Periodic progressive wave of the full Euler equations, with the velocities inside",
      .citation =
          "Schwartz, Computer extension and analytic continuation of Stokes' expansion for gravity waves, J. Fluid "
          "Mech. 62 (1974) 553; Cokelet, Steep gravity waves in water of arbitrary uniform depth, Phil. Trans. R. Soc. "
          "A 286 (1977) 183; Longuet-Higgins, Integral properties of periodic gravity waves, Proc. R. Soc. A 342 "
          "(1975) 157",
      .formula =
          "theta = T tau with the symbol -i tanh(k d), c^2/2 d(q^2)/dphi + sin(theta)/q = 0, q = exp(tau), int "
          "cos(theta)/q dphi = 2 pi; f = c (1 - dW/dz) inside by a quotient of Cauchy sums",
      .parameters = {{"amplitude", "m", 0.1, 1e-9, 1e6, "half the height from trough to crest"},
                     wavelength_parameter(),
                     depth_parameter(infinite, infinite),
                     {"conformal_depth", "m", 0, 0, infinite,
                      "discharge under the wave over its speed; where positive it takes the place of depth"},
                     gravity_parameter()},
      .inputs = {position_x, height_y, time_t},
      .outputs = {{"eta", "m", "surface elevation above the mean level"}, velocity_u, velocity_v},
      .scalars = {{"c", "m/s", "phase speed, mean velocity below the troughs zero", &StokesWave::phase_speed},
                  {"mean_depth", "m", "mean depth", &StokesWave::mean_depth},
                  {"conformal_depth", "m", "conformal depth", &StokesWave::conformal_depth},
                  {"crest_elevation", "m", "crest above the mean level", &StokesWave::crest_elevation},
                  {"trough_elevation", "m", "trough, negative", &StokesWave::trough_elevation},
                  {"bernoulli_constant", "m^2/s^2", "q^2/2 + g eta on the surface, seen from the wave",
                   &StokesWave::bernoulli_constant},
                  {"impulse", "m^2/s", "mean impulse, density 1", &StokesWave::impulse},
                  {"kinetic", "m^3/s^2", "mean kinetic energy, density 1", &StokesWave::kinetic_energy},
                  {"potential", "m^3/s^2", "mean potential energy, density 1", &StokesWave::potential_energy},
                  {"crest_velocity", "m/s", "horizontal velocity at the crest", &StokesWave::crest_velocity},
                  {"maximum_slope", "rad", "largest inclination of the surface", &StokesWave::maximum_slope}},
      .make = made_by(
          [](double amplitude, double wavelength, double depth, double conformal, double gravity) {
            return conformal > 0 ? StokesWave::from_conformal_depth(amplitude, wavelength, conformal, gravity)
                                 : StokesWave(amplitude, wavelength, depth, gravity);
          },
          "amplitude", "wavelength", "depth", "conformal_depth", "gravity"),
      .row = wave_row<StokesWave>};
}

}  // namespace seiche::exact
