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
#pragma once

#include <Eigen/Core>

#include "seiche/exact/affine_drop.hpp"

namespace seiche::exact {

/// Of the drop at one instant: larger and smaller semi-axis [m], and the angle from x to the larger one, in
/// (-pi/2, pi/2].
struct Ellipse {
  double major, minor, tilt;
};
Ellipse outline_of(const DropInstant& instant);

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

}  // namespace seiche::exact
