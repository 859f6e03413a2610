/// Free liquid ellipsoid in affine motion (Dirichlet 1861), in space, no gravity, zero pressure on the surface.
///
/// What was the ball |X| <= radius is at time t the ellipsoid of the places x = A(t) X, A(0) = 1: the velocity is
/// linear, the pressure quadratic in x,
///
///     u = A' A^-1 x,   p = (lambda/2) rho (radius^2 - |X|^2),   A'' = lambda A^-T,
///     lambda = tr[(A' A^-1)^2] / tr[A^-1 A^-T],
///
/// which keeps det A = 1, the kinetic energy (m radius^2/10) tr(A'^T A'), the angular momentum (antisymmetric part of
/// A A'^T) and the circulation (that of A^T A'). If A is a motion, so is its transpose (Dedekind): the water then turns
/// in the ellipsoid as the ellipsoid turned about the water, and momentum and circulation change places.
///
/// When not to use it: lambda < 0 (rotation faster than strain) is a solution, but with the pressure below that of the
/// surroundings everywhere, and its surface is unstable; self-gravitating ellipsoids.
///
/// References: Dirichlet, J. reine angew. Math. 58 (1861) 181; Dedekind, ibid. 217; Chandrasekhar, Ellipsoidal figures
/// of equilibrium (1969), chapter 4.
#pragma once

#include <Eigen/Core>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class AffineEllipsoid {
 public:
  struct Instant {
    Eigen::Matrix3d deformation;  ///< A
    Eigen::Matrix3d rate;         ///< A' [1/s]
    double central_pressure = 0;  ///< over the density [m^2/s^2]
  };

  /// @param velocity_gradient  A'(0) [1/s], trace 0 to round-off;  @param radius  of the ball [m]
  /// Throws std::invalid_argument.
  explicit AffineEllipsoid(const Eigen::Matrix3d& velocity_gradient, double radius = 1);

  /// State at time t [s], of either sign; integrates from t = 0 by Runge-Kutta-Fehlberg 7(8), tolerance 1e-14 per step.
  [[nodiscard]] Instant at(double t) const;

  /// Semi-axes [m], the largest first.
  [[nodiscard]] Eigen::Vector3d semi_axes(const Instant& instant) const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] Instant from(const Eigen::Matrix3d& deformation, const Eigen::Matrix3d& rate, double t) const;

  Eigen::Matrix3d gradient_;
  double radius_;
  double strength_;  ///< Frobenius norm of the velocity gradient, 1 if at rest
};

}  // namespace seiche::exact
