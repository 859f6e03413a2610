/// Exact dispersion law of the discrete layer of the two-dimensional Lagrangian mesh (Frank 1994, section 2.1).
///
/// n rows of height h2 = H/n, columns of width h1, infinitesimal waves of wavenumber k, 0 < k h1 <= pi. With
///
///     T = (h2/h1) tan(k h1/2),   t_n = tanh(2 n artanh T) = [(1+T)^2n - (1-T)^2n]/[(1+T)^2n + (1-T)^2n],
///
///     omega^2 = (2 g/h2) ((2 + cos k h1)/3) T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n).
///
/// b is the vertical inertia of a surface node over rho h1 h2: 1/2 with nodal masses, when the denominator is
/// 1 - T^3 t_n, and 1/2 - h2/(6 H) when tuned. (2 + cos k h1)/3 comes from the polygon's potential energy. Multipliers
/// vary like cosh(2 (j + 1/2) artanh T) over the rows; for T > 1 they alternate.
///
///     fine meshes       omega^2 -> g k tanh kH
///     long waves        omega^2 = g H k^2 (1 - (1/3 + (h2/H)^2/6) (kH)^2 + ...); tuned: -1/3 without h2
///     shortest wave     k h1 = pi: omega^2 = g/(3 b h2)
///     one row           Frank's formula (13) (FrankDispersion) with alpha = b: 1/2 with nodal masses, 1/3 tuned
///
/// A time step changes omega as in FrankDispersion: discrete_frequency().
///
/// When not to use it: columns of unequal width, an uneven bottom, waves of finite amplitude, the hourglass potential.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 2. The closed form
/// follows from the linearised equations: inner rows give tanh(kappa/2) = T, the bottom mirrors, the surface closes.
#pragma once

#include <cstddef>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

/// Vertical inertia of surface nodes: their mass, or reduced so that long waves have Airy's frequency to one more
/// power.
enum class SurfaceInertia { nodal, tuned };

class LagrangianMeshDispersion {
 public:
  /// @param column_width  h1 [m];  @param rows  n. Throws std::invalid_argument unless all are positive.
  LagrangianMeshDispersion(double gravity, double depth, double column_width, std::size_t rows,
                           SurfaceInertia inertia = SurfaceInertia::nodal);

  /// omega(k) [1/s] and omega/k [m/s], 0 < k <= pi/h1. Throw std::invalid_argument.
  [[nodiscard]] double frequency(double wavenumber) const;
  [[nodiscard]] double phase_speed(double wavenumber) const;
  /// The largest over 0 < k <= pi/h1: the one-step scheme is stable for tau < 2/omega.
  [[nodiscard]] double largest_frequency() const;
  /// Speed that a vertical impulse on the surface leaves it with, over the speed that the impulse would give to the
  /// surface nodes if they were free: b omega^2 h2/(g (2 + cos k h1)/3).
  [[nodiscard]] double surface_response(double wavenumber) const;

  [[nodiscard]] double column_width() const { return column_width_; }
  [[nodiscard]] double row_height() const { return depth_ / static_cast<double>(rows_); }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  void require_resolved(double wavenumber) const;
  /// T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n).
  [[nodiscard]] double response_of_rows(double wavenumber) const;
  [[nodiscard]] double by_recurrence(double wavenumber) const;

  double gravity_;
  double depth_;
  double column_width_;
  std::size_t rows_;
  double inertia_;
};

}  // namespace seiche::exact
