/// Exact dispersion law of the three-dimensional Lagrangian mesh: n layers of hexahedra of height h3 = H/n on a
/// rectangular plan lattice h1, h2.
///
///     T_i = (2/h_i) tan(k_i h_i/2),   K^2 = T1^2 + T2^2,   G = ((2 + cos k1 h1)/3) ((2 + cos k2 h2)/3),   |k_i| h_i <=
///     pi theta = K h3/2,   t_n = tanh(2 n artanh theta)
///
///     omega^2 = (2 g/h3) G theta (1 - theta^2) t_n/(1 - theta t_n + 2 b theta (1 - theta^2) t_n)
///
/// b is the vertical inertia of a surface node over that of an inner one: 1/2 with nodal masses, when the denominator
/// is 1 - theta^3 t_n, and 1/2 - 1/(6n) when tuned. With P, Q = cosh(mu (1 - h/2)), cosh(mu (1 - 3h/2)) the multipliers
/// of the two upper layers (depth 1, h = 1/n, tanh(mu h/2) = theta) the nodal law is also (2 g G/h) [theta^2 (Q + 3P) +
/// P - Q]/[theta^2 (Q + 3P) + 3P - Q]; the form above does not cancel, and holds for theta > 1, where mu is complex and
/// multipliers alternate from layer to layer.
///
///     fine meshes        omega^2 -> g k tanh kH
///     k2 = 0             the two-dimensional mesh (LagrangianMeshDispersion)
///     one layer          omega^2 = g H G K^2/(1 + b H^2 K^2): PlanDispersion with alpha = b, 1/3 when tuned
///     shortest waves     k_i h_i = pi: omega^2 = g G/(b h3)
///
/// A time step changes omega as in FrankDispersion: discrete_frequency().
///
/// When not to use it: a deformed mesh, layers of unequal height, an uneven bottom, waves of finite amplitude.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 4.1. The closed
/// form follows from the linearised cells: inner layers give tanh(mu h3/2) = theta, the bottom mirrors, the surface
/// closes.
#pragma once

#include <cstddef>

#include "seiche/exact/lagrangian_mesh_dispersion.hpp"
#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class HexahedralDispersion {
 public:
  /// @param spacing_x, spacing_y  h1, h2 [m];  @param layers  n. Throws std::invalid_argument unless all are positive.
  HexahedralDispersion(double gravity, double depth, double spacing_x, double spacing_y, std::size_t layers,
                       SurfaceInertia inertia = SurfaceInertia::nodal);

  /// omega [1/s] and omega/|k| [m/s] of the wavenumber (kx, ky) [1/m], |k_i| h_i <= pi, not 0. Throw
  /// std::invalid_argument.
  [[nodiscard]] double frequency(double kx, double ky) const;
  [[nodiscard]] double phase_speed(double kx, double ky) const;

  /// Relative error of the frequency against Airy's law, for the wavenumber at `direction` from the x axis [rad].
  [[nodiscard]] double frequency_error(double wavenumber, double direction) const;
  /// sqrt(g/(b h3)) [1/s], above every frequency: the one-step scheme is stable for tau < 2/bound.
  [[nodiscard]] double frequency_bound() const;

  [[nodiscard]] double layer_height() const { return depth_ / static_cast<double>(layers_); }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  /// The frequency, from the layers one by one instead of the closed form.
  [[nodiscard]] double by_layers(double kx, double ky) const;

  double gravity_;
  double depth_;
  double spacing_x_;
  double spacing_y_;
  std::size_t layers_;
  double inertia_;
};

}  // namespace seiche::exact
