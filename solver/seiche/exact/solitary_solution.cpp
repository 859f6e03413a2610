#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "seiche/exact/conformal_newton.hpp"
#include "seiche/exact/solitary_surface.hpp"

namespace seiche::exact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

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

struct Grid {
  LineNodes nodes{1, 1};
  double spacing = 0;
  VectorXd potential;
  VectorXd stretch;
};

/// @param tail  the wave is followed until it has decayed by exp(-tail)
Grid make_grid(double froude_squared, double crest_speed, double spacing, double clustering, double tail) {
  const double decay = solitary_decay_rate(froude_squared);
  // The nearest singularity lies q^3 F^2 above the crest; below a ~ 0.07 the wave is long and needs no cluster.
  constexpr double long_wave = 0.45;
  const bool clustered = decay > long_wave;
  const double rate = clustered ? 0.8 : 1.1 * decay;
  const double width = clustered ? std::min(0.9, clustering * rate * std::pow(crest_speed, 3) * froude_squared) : 1;
  const double longest = rate * std::max(tail / decay, clustered ? 1.25 * tail : 0) - std::log(width);
  Grid grid{LineNodes(width, rate), spacing, {}, {}};
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
  SolitaryEquations(const Grid& grid, SolitaryCrest crest)
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
  SolitaryCrest crest_;
};

SolitarySolution solve_on(const Grid& grid, SolitaryCrest crest, VectorXd elevation, double froude_squared) {
  const Index count = grid.stretch.size();
  VectorXd unknowns(count + 1);
  unknowns << elevation, froude_squared;
  const SolitaryEquations equations(grid, crest);
  SolitarySolution solution{grid.nodes, grid.spacing, grid.potential, grid.stretch, {}, {}, 1, 0};
  solution.correction = solve_newton(equations, unknowns);
  solution.elevation = unknowns.head(count);
  solution.froude_squared = unknowns[count];
  solution.inclination = equations.inclination(unknowns);
  return solution;
}

/// The elevation of a solution at the nodes of another grid, scaled to another crest.
VectorXd transfer(const SolitarySolution& from, const Grid& to, double crest) {
  const VectorXd none = VectorXd::Zero(from.elevation.size());
  const SincInterpolation interpolation(from.spacing, from.elevation, none, none);
  const double last = from.spacing * static_cast<double>(from.elevation.size() - 1);
  VectorXd elevation(to.potential.size());
  for (Index j = 0; j < elevation.size(); ++j) {
    const double s = from.nodes.label(to.potential[j]);
    elevation[j] = s < last ? interpolation.at(s).elevation * crest / from.elevation[0] : 0;
  }
  return elevation;
}

double crest_speed_of(const SolitarySolution& wave) {
  return std::sqrt(1 - 2 * wave.elevation[0] / wave.froude_squared);
}

}  // namespace

double solitary_decay_rate(double froude_squared) {
  // Bisection to the neighbourhood, then Newton's method on sin(kappa) - F^2 kappa cos(kappa).
  double low = 0;
  double high = pi / 2;
  double kappa = std::min(1.2, std::sqrt(3 * (froude_squared - 1)));
  for (int step = 0; step < 80; ++step) {
    const double value = std::sin(kappa) - froude_squared * kappa * std::cos(kappa);
    (value < 0 ? low : high) = kappa;
    const double slope = std::cos(kappa) * (1 - froude_squared) + froude_squared * kappa * std::sin(kappa);
    const double next = kappa - value / slope;
    if (std::abs(next - kappa) < 1e-15 * kappa) break;
    kappa = next > low && next < high ? next : 0.5 * (low + high);
  }
  return kappa;
}

SolitarySolution solve_solitary_wave(SolitaryCrest crest, Resolution resolution) {
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
  Grid grid = make_grid(froude_squared, std::sqrt(1 - 2 * start / froude_squared), coarse_spacing, 1, coarse_tail);
  const double steepness = std::sqrt(0.75 * start / (1 + start));
  const VectorXd rayleigh = start * (steepness * grid.potential.array()).cosh().square().inverse();
  SolitarySolution wave = solve_on(grid, {start, {}}, rayleigh, froude_squared);
  // Step 2: towards the limiting wave, in the speed at the crest.
  const auto reached = [&] {
    return crest.amplitude ? wave.elevation[0] >= *crest.amplitude * (1 - 1e-12)
                           : crest_speed_of(wave) <= *crest.speed * (1 + 1e-4);
  };
  while (!reached()) {
    const double speed = std::max(step * crest_speed_of(wave), crest.speed.value_or(0));
    if (speed < least_speed || !(wave.correction < 1e-4)) {
      throw std::invalid_argument(
          fmt::format("amplitude/depth = {:.17g} is above the limiting solitary wave: the last wave that converged has "
                      "{:.8g}, with "
                      "the speed {:.3g} c at its crest",
                      target, wave.elevation[0], crest_speed_of(wave)));
    }
    grid = make_grid(wave.froude_squared, speed, coarse_spacing, 1, coarse_tail);
    const double height = 0.5 * wave.froude_squared * (1 - speed * speed);
    wave = solve_on(grid, {{}, speed}, transfer(wave, grid, height), wave.froude_squared);
  }
  if (crest.amplitude) {
    auto close = solve_on(grid, crest, transfer(wave, grid, *crest.amplitude), wave.froude_squared);
    if (close.correction < 1e-4) wave = std::move(close);
  }
  // Step 3: the wave asked for on fine nodes.
  const double height = crest.amplitude ? *crest.amplitude : wave.elevation[0];
  const double speed = std::sqrt(std::max(1 - 2 * height / wave.froude_squared, least_speed * least_speed));
  grid = make_grid(wave.froude_squared, crest.speed.value_or(speed), fine_spacing / resolution.refinement,
                   resolution.clustering, fine_tail);
  wave = solve_on(grid, crest, transfer(wave, grid, height), wave.froude_squared);
  if (!(wave.correction < 1e-9)) {
    throw std::invalid_argument(
        fmt::format("amplitude/depth = {:.17g}: Newton's method stopped at a correction of {:.1e}; lower the amplitude "
                    "or raise the resolution",
                    target, wave.correction));
  }
  return wave;
}

}  // namespace seiche::exact
