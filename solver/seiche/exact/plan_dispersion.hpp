/// Dispersion of the discrete dispersive shallow-water model in plan: markers on a rectangular lattice of spacings h1,
/// h2 on still water of depth H.
///
///     omega^2 = g H G K^2/(1 + alpha H^2 K^2)
///     T_i = (2/h_i) tan(k_i h_i/2),   K^2 = T1^2 + T2^2,   G = ((2 + cos k1 h1)/3) ((2 + cos k2 h2)/3),   |k_i| h_i <=
///     pi
///
/// The volume of a cell allows Z = -i H (T1 X + T2 Y) for the displacement (X, Y, Z) of a marker; of all motions with
/// that Z the one along (T1, T2) has the least kinetic energy, |Z'|^2 (alpha + 1/(H K)^2)/2 per unit mass. The total
/// volume below the bilinear patches being constant, the potential energy is that of the patches about the still level,
/// g G |Z|^2/2 per unit area. All other motions are vortices, omega = 0. For k2 = 0 it is formula (13) of the source
/// (FrankDispersion).
///
///     h_i -> 0           omega^2 = g H k^2/(1 + alpha H^2 k^2), k = |k|: the Green-Naghdi equations
///     leading error      -(k1^2 h1^2 + k2^2 h2^2)/12 + (k1^4 h1^2 + k2^4 h2^2)/(12 k^2 (1 + alpha H^2 k^2)) of omega;
///                        for long waves -(h1^2 + h2^2) k1^2 k2^2/(12 k^2): none along the axes, largest at 45 degrees
///     shortest waves     k_i h_i = pi: omega^2 = g G/(alpha H), the same without a bound on the other component
///
/// A time step changes omega as in FrankDispersion: discrete_frequency().
///
/// When not to use it: a deformed lattice, an uneven bottom, waves of finite amplitude.
///
/// References: Frank, Discrete models of incompressible fluids (1994), ch. 3, formula (13), and section 4.2; the closed
/// form follows from the linearised cells. Trefethen, Group velocity in finite difference schemes, SIAM Review 24
/// (1982) 113 (anisotropy).
#pragma once

#include "seiche/exact/dispersion.hpp"

namespace seiche::exact {

class PlanDispersion {
 public:
  struct Vector {
    double x = 0;
    double y = 0;
  };

  /// @param spacing_x, spacing_y  h1, h2 [m];  @param alpha  factor of the vertical kinetic energy
  /// Throws std::invalid_argument unless all are positive.
  PlanDispersion(double gravity, double depth, double spacing_x, double spacing_y, double alpha = 1.0 / 3);

  /// omega [1/s] and omega/|k| [m/s] of the wavenumber (kx, ky) [1/m], |k_i| h_i <= pi, not 0. Throw
  /// std::invalid_argument.
  [[nodiscard]] double frequency(double kx, double ky) const;
  [[nodiscard]] double phase_speed(double kx, double ky) const;
  /// d omega/d(kx, ky) [m/s], |k_i| h_i < pi: not along k unless k is along an axis or a diagonal of square cells.
  [[nodiscard]] Vector group_velocity(double kx, double ky) const;

  /// The law without a lattice, h_i -> 0: isotropic.
  [[nodiscard]] RationalDispersion limit() const;
  /// Relative error of the frequency against the limit, for the wavenumber at `direction` from the x axis [rad]: the
  /// anisotropy of the lattice.
  [[nodiscard]] double frequency_error(double wavenumber, double direction) const;
  /// Its leading term, of second order in the spacings.
  [[nodiscard]] double leading_error(double wavenumber, double direction) const;
  /// sqrt(g/(alpha H)) [1/s], above every frequency: the one-step scheme is stable for tau < 2/bound, whatever the
  /// spacing.
  [[nodiscard]] double frequency_bound() const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_;
  double depth_;
  double spacing_x_;
  double spacing_y_;
  double alpha_;
};

}  // namespace seiche::exact
