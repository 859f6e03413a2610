/// Free liquid ellipse in affine motion (Dirichlet 1860), plane, no gravity, zero pressure on the surface.
///
/// Particles x = A(t) X, X in the unit disc. The velocity is linear and the pressure quadratic in x,
///
///     u = A' A^-1 x,   p = (lambda/2) rho (1 - |X|^2),   A'' = lambda A^-T,
///     lambda = tr[(A' A^-1)^2] / tr[A^-1 A^-T],
///
/// which keeps det A, the kinetic energy rho det A (pi/8) tr(A'^T A'), the angular momentum (A A'^T antisymmetric part)
/// and the circulation (A^T A' antisymmetric part). Every particle's path is known exactly: the sharpest test of a
/// Lagrangian free-surface method, with large deformation.
///
/// When not to use it: lambda < 0 (rotation faster than strain) is a solution, but with the pressure below that of the
/// surroundings everywhere, and its surface is unstable.
///
/// References: Dirichlet, Untersuchungen ueber ein Problem der Hydrodynamik, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860)
/// 3; Longuet-Higgins, A class of exact, time-dependent, free-surface flows, J. Fluid Mech. 55 (1972) 529.
///
/// Free liquid ellipse that is stretched without rotation: the irrotational, symmetric case of affine_drop.hpp.
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
/// When not to use it: drops that rotate (affine_drop.hpp).
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
  [[nodiscard]] bool contains(double x, double y) const;
  /// Larger and smaller semi-axis [m], and the angle from x to the larger one, in (-pi/2, pi/2].
  struct Ellipse {
    double major, minor, tilt;
  };
  [[nodiscard]] Ellipse outline() const;

 private:
  [[nodiscard]] Eigen::Vector2d label(double x, double y) const;
};

class AffineDrop {
 public:
  /// @param deformation        A(0), unit disc to drop [m], det > 0
  /// @param velocity_gradient  A'(0) A(0)^-1 [1/s], trace 0 to round-off
  /// @param density            [kg/m^3]
  /// Throws std::invalid_argument.
  AffineDrop(const Eigen::Matrix2d& deformation, const Eigen::Matrix2d& velocity_gradient, double density = 1);

  /// State at time t [s], of either sign; integrates from t = 0 by Runge-Kutta-Fehlberg 7(8), tolerance 1e-14 per step.
  [[nodiscard]] DropInstant at(double t) const;
  /// Position at time t of the particle that was at (x0, y0) at t = 0. Throws OutsideFluid.
  [[nodiscard]] Eigen::Vector2d carried(double x0, double y0, double t) const;

  /// Constants of the motion, per unit span: area [m^2], kinetic energy [J/m], angular momentum [N s], circulation of
  /// the surface [m^2/s].
  struct Invariants {
    double area, kinetic_energy, angular_momentum, circulation;
  };
  [[nodiscard]] Invariants invariants(const DropInstant& instant) const;

  [[nodiscard]] double uncertainty() const { return 1e-12; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  Eigen::Matrix2d deformation_;
  Eigen::Matrix2d rate_;
  double density_;
  double size_;      ///< sqrt(det A)
  double strength_;  ///< Frobenius norm of the velocity gradient, 1 if at rest
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
