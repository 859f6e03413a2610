#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <Eigen/Core>

#include "seiche/linear/dense.hpp"

namespace seiche::exact {

/// A square nonlinear system with an exact Jacobian.
template <class S>
concept NewtonSystem = requires(const S& system, const Eigen::VectorXd& unknowns, Eigen::MatrixXd& jacobian) {
  { system.residual(unknowns) } -> std::convertible_to<Eigen::VectorXd>;
  system.jacobian(unknowns, jacobian);
  { system.admissible(unknowns) } -> std::convertible_to<bool>;
};

/// Newton's method with steps halved until they are admissible; once the correction is below 1e-3 the factors are kept
/// and iterated until the correction no longer shrinks: the rounding of the residual.
///
/// @returns the last correction (maximum norm), infinite without convergence
template <NewtonSystem System>
double solve_newton(const System& system, Eigen::VectorXd& unknowns) {
  constexpr int most_steps = 30;
  constexpr double refine_below = 1e-3;
  Eigen::MatrixXd jacobian;
  for (int step = 0; step < most_steps; ++step) {
    system.jacobian(unknowns, jacobian);
    const linear::LuFactors factors(jacobian);
    Eigen::VectorXd correction = factors.solve(system.residual(unknowns));
    double size = correction.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) break;
    double damping = 1;
    while (damping > 1e-6 && !system.admissible(unknowns - damping * correction)) damping /= 2;
    unknowns -= damping * correction;
    if (size > refine_below) continue;
    for (int refinement = 0; refinement < 20; ++refinement) {
      correction = factors.solve(system.residual(unknowns));
      const double previous = size;
      size = correction.lpNorm<Eigen::Infinity>();
      if (!(size < 0.5 * previous)) break;
      unknowns -= correction;
    }
    return size;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace seiche::exact
