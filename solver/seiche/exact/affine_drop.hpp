/// Free liquid ellipse that is stretched without rotation: affine motion (Dirichlet 1860), plane, no gravity, zero
/// pressure on the surface. Every particle's path is known exactly.
///
/// Semi-axes a(t) along x and b(t) along y, a b = c^2 constant, u = alpha x, v = -alpha y, alpha = a'/a,
///
///     alpha' = alpha^2 (b^2 - a^2)/(a^2 + b^2),   so   alpha^2 (a^2 + b^2) = C   is constant,
///     p = rho alpha^2 a^2 b^2/(a^2 + b^2) (1 - x^2/a^2 - y^2/b^2).
///
/// The time is a quadrature; with sigma = (a - b)/(2 c), nearly proportional to it,
///
///     t = (c/sqrt C) int sqrt(2 (1 + 2 sigma^2)/(1 + sigma^2)) d sigma.
///
/// This is the stretching patch on which particle methods are usually judged.
///
/// When not to use it: drops that rotate.
///
/// References: Dirichlet (1860); Longuet-Higgins, A class of exact, time-dependent, free-surface flows, J. Fluid Mech.
/// 55 (1972) 529; Monaghan, Simulating free surface flows with SPH, J. Comput. Phys. 110 (1994) 399.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

/// The drop at one instant.
struct DropInstant {
  Eigen::Matrix2d deformation;  ///< A: unit disc to drop [m]
  Eigen::Matrix2d rate;         ///< A' [m/s]
  double central_pressure = 0;  ///< rho lambda/2 [Pa]

  /// Velocity [m/s] and pressure [Pa] at (x, y). Throw OutsideFluid.
  [[nodiscard]] Eigen::Vector2d velocity(double x, double y) const { return rate * label(x, y); }
  [[nodiscard]] double pressure(double x, double y) const { return central_pressure * (1 - label(x, y).squaredNorm()); }

 private:
  [[nodiscard]] Eigen::Vector2d label(double x, double y) const;
};

class StretchingDrop {
 public:
  /// @param semi_axis    a(0) along x [m];  @param other_axis  b(0) along y [m]
  /// @param strain_rate  alpha(0) [1/s], either sign, not 0;  @param density  [kg/m^3]
  /// Throws std::invalid_argument.
  StretchingDrop(double semi_axis, double other_axis, double strain_rate, double density = 1);

  /// Semi-axes [m] and strain rate alpha [1/s] at time t, of either sign.
  [[nodiscard]] double semi_axis(double t) const;
  [[nodiscard]] double other_axis(double t) const;
  [[nodiscard]] double strain_rate(double t) const { return rate_at(elongation(t)); }
  /// Time at which the semi-axis along x is, was or will be this long [s].
  [[nodiscard]] double time_of(double semi_axis) const;

  [[nodiscard]] DropInstant at(double t) const;
  /// Position at time t of the particle that was at (x0, y0) at t = 0. Throws OutsideFluid.
  [[nodiscard]] Eigen::Vector2d carried(double x0, double y0, double t) const;
  /// C = alpha^2 (a^2 + b^2) [m^2/s^2], constant; the kinetic energy is rho pi c^2 C/8 per unit span.
  [[nodiscard]] double invariant() const { return invariant_; }

  [[nodiscard]] double uncertainty() const { return 1e-14; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double elongation(double t) const;
  [[nodiscard]] double rate_at(double elongation) const;
  [[nodiscard]] double time_between(double from, double to) const;

  double mean_axis_;  ///< c
  double start_;      ///< sigma(0)
  double invariant_;  ///< C
  double direction_;  ///< sign of alpha
  double density_;
};

}  // namespace seiche::exact
