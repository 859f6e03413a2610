#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "seiche/exact/conformal_newton.hpp"
#include "seiche/exact/stokes_surface.hpp"

namespace seiche::exact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
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

struct PeriodicGrid {
  PeriodicNodes nodes{1};
  double depth = 0;
  std::vector<long double> exact_potential;
  VectorXd potential;
  VectorXd stretch;
};

PeriodicGrid make_grid(double speed_squared, double crest_speed, double depth, Resolution resolution) {
  // The nearest singularity lies q^3 c^2 above the crest.
  const double width = std::min(1.0, resolution.clustering * std::pow(crest_speed, 3) * speed_squared);
  PeriodicGrid grid{PeriodicNodes(width), depth, {}, {}, {}};
  const double quarter = grid.nodes.quarter_period();
  // Half the number of nodes: resolution of the surface, and steps below 0.15 depth for the kernel.
  const double half_count = std::max(56 * quarter / pi + 20, 2 * quarter / (0.15 * depth));
  const auto count = static_cast<Index>(std::ceil(resolution.refinement * half_count)) + 1;
  grid.potential.resize(count);
  grid.stretch.resize(count);
  for (Index j = 0; j < count; ++j) {
    const auto node = grid.nodes.at(pi * static_cast<double>(j) / static_cast<double>(count - 1));
    grid.exact_potential.push_back(node.potential);
    grid.potential[j] = static_cast<double>(node.potential);
    grid.stretch[j] = node.stretch;
  }
  return grid;
}

/// theta = T tau by the trapezoidal rule on alternate points; rows 1..m-1, theta vanishes at crest and trough.
MatrixXd periodic_conjugate(const PeriodicGrid& grid) {
  const Index count = grid.stretch.size();
  const Index last = count - 1;
  const double weight = 2 * pi / static_cast<double>(last);
  const PeriodicKernel kernel(grid.depth);
  const auto phi = [&](Index i) { return grid.exact_potential[static_cast<std::size_t>(i)]; };
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index i = (j + 1) % 2; i < j; i += 2) {
      const double behind = kernel(static_cast<double>(phi(j) - phi(i)));
      const double ahead = i > 0 && j < last ? kernel(static_cast<double>(phi(i) + phi(j))) : 0;
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
  StokesEquations(const PeriodicGrid& grid, StokesCrest crest)
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
  StokesCrest crest_;
};

StokesSolution solve_on(const PeriodicGrid& grid, StokesCrest crest, const VectorXd& log_speed, double speed_squared) {
  const Index count = grid.stretch.size();
  VectorXd unknowns(count + 1);
  unknowns << log_speed, speed_squared;
  const StokesEquations equations(grid, crest);
  StokesSolution solution{grid.nodes, grid.potential, grid.stretch, {}, {}, 1, grid.depth, 0};
  solution.correction = solve_newton(equations, unknowns);
  solution.log_speed = unknowns.head(count);
  solution.speed_squared = unknowns[count];
  solution.inclination = equations.inclination(unknowns);
  return solution;
}

/// tau of a solution at the nodes of another grid, scaled to another crest.
VectorXd transfer(const StokesSolution& from, const PeriodicGrid& to, double crest_log_speed) {
  const VectorXd none = VectorXd::Zero(from.log_speed.size());
  const TrigonometricInterpolation interpolation(from.log_speed, none, none);
  VectorXd result(to.potential.size());
  for (Index j = 0; j < result.size(); ++j) {
    result[j] = interpolation.at(from.nodes.label(to.potential[j])).elevation * crest_log_speed / from.log_speed[0];
  }
  return result;
}

/// Continuation to the crest asked for on coarser nodes.
StokesSolution approach(StokesCrest crest, double depth, Resolution resolution) {
  constexpr double step = 0.105;  // q falls by a tenth
  constexpr double least_speed = 1.2e-3;
  const double linear_speed_squared = std::tanh(depth);
  const double wanted = crest.amplitude ? *crest.amplitude / linear_speed_squared : -std::log(*crest.speed);
  const double start = std::min({0.05, 0.5 * depth * depth, 0.8 * wanted});
  const Resolution coarse{0.5 * resolution.refinement, resolution.clustering};
  PeriodicGrid grid = make_grid(linear_speed_squared, std::exp(-start), depth, coarse);
  StokesSolution wave =
      solve_on(grid, {{}, std::exp(-start)}, -start * grid.potential.array().cos(), linear_speed_squared);
  const auto reached = [&] {
    return crest.amplitude ? wave.amplitude() >= *crest.amplitude * (1 - 1e-9)
                           : wave.log_speed[0] <= std::log(*crest.speed) + 1e-12;
  };
  StokesSolution last = wave;
  while (!reached()) {
    const double slope = std::min(-1.6 * wave.log_speed[0], step - wave.log_speed[0]);
    const double speed = std::max(std::exp(-slope), crest.speed.value_or(0));
    const bool converged = wave.correction < 1e-6;
    // a = c^2 (q_trough^2 - q^2)/4: near the limiting wave no more than about c^2 q^2/4 is left.
    const double left = wave.speed_squared * std::exp(2 * wave.log_speed[0]);
    const bool beyond =
        crest.amplitude && wave.log_speed[0] < std::log(0.1) && *crest.amplitude > wave.amplitude() + left;
    if (converged) last = wave;
    if (speed < least_speed || !converged || beyond) {
      throw std::invalid_argument(fmt::format(
          "k amplitude = {:.17g} is above the limiting Stokes wave for k times conformal depth = {:g}: the last wave "
          "that converged has {:.8g}, with the speed {:.3g} c at its crest",
          wanted * (crest.amplitude ? linear_speed_squared : 1), depth, last.amplitude(), std::exp(last.log_speed[0])));
    }
    grid = make_grid(wave.speed_squared, speed, depth, coarse);
    wave = solve_on(grid, {{}, speed}, transfer(wave, grid, std::log(speed)), wave.speed_squared);
  }
  if (!crest.amplitude) return wave;
  StokesSolution close = solve_on(grid, crest, wave.log_speed, wave.speed_squared);
  return close.correction < 1e-6 ? close : wave;
}

}  // namespace

double StokesSolution::amplitude() const {
  const double trough = log_speed[log_speed.size() - 1];
  return 0.25 * speed_squared * (std::expm1(2 * trough) - std::expm1(2 * log_speed[0]));
}

StokesSolution solve_stokes_wave(StokesCrest crest, double conformal_depth, Resolution resolution,
                                 const StokesSolution* nearby) {
  const StokesSolution close = nearby ? *nearby : approach(crest, conformal_depth, resolution);
  const PeriodicGrid grid = make_grid(close.speed_squared, std::exp(close.log_speed[0]), conformal_depth, resolution);
  StokesSolution wave = solve_on(grid, crest, transfer(close, grid, close.log_speed[0]), close.speed_squared);
  if (!(wave.correction < 1e-8)) {
    throw std::invalid_argument(fmt::format(
        "k amplitude = {:.17g}, k depth = {:g}: Newton's method stopped at a correction of {:.1e}; lower the "
        "amplitude or raise the resolution",
        crest.amplitude.value_or(wave.amplitude()), conformal_depth, wave.correction));
  }
  return wave;
}

}  // namespace seiche::exact
