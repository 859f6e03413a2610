/// Manufactured solution in Lagrangian form: a prescribed motion of the water, with the body force that sustains it.
///
///     x(label, t) = label + A sin(k label) sin(w t),   walls at 0 and length, k = 2 pi/length
///
/// Mass is exact by construction: J = 1 + A k cos(k label) sin(w t), h = H/J. The momentum equation then needs the
/// force per unit mass f = x_tt + (g/J) d(H/J)/d label = -A w^2 sin(k label) sin(w t) - g H J_label/J^3, J_label = -A
/// k^2 sin(k label) sin(w t). On an uneven bed add g z_x(x).
///
/// When not to use it: methods that cannot take a body force.
///
/// References: Roache, Code verification by the method of manufactured solutions, J. Fluids Eng. 124 (2002) 4.
#pragma once

#include "seiche/exact/reference_solution.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::validation {

class LagrangianManufactured {
 public:
  /// @param depth      still-water depth H [m];  @param length  of the basin [m]
  /// @param amplitude  A [m], A k < 1 so that particles do not cross;  @param frequency  w [1/s]
  /// Throws std::invalid_argument.
  explicit LagrangianManufactured(double gravity = 9.81, double depth = 1, double length = 1, double amplitude = 0.05,
                                  double frequency = 3);

  /// State at (x, t), x in [0, length].
  [[nodiscard]] shallow_water::State at(double x, double t) const;
  /// Body force per unit mass f(x, t) [m/s^2] on a flat bed.
  [[nodiscard]] double source(double x, double t) const;

  /// Position of the particle with this label (its place at t = 0) [m]: exact reference for edges.
  [[nodiscard]] double position(double label, double t) const;
  /// Label of the particle at x: Newton's method within a bracket.
  [[nodiscard]] double label(double x, double t) const;
  /// Mean velocity of the water between two labels (by mass) [m/s].
  [[nodiscard]] double mean_velocity(double left_label, double right_label, double t) const;
  /// Force and state in terms of the label, without inversion.
  [[nodiscard]] double source_of(double label, double t) const;
  [[nodiscard]] shallow_water::State state_of(double label, double t) const;

 private:
  double gravity_, depth_, length_, amplitude_, frequency_, wavenumber_;
};

}  // namespace seiche::validation
