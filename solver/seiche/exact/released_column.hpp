/// Pressure in a column of water at the instant when the wall that held it is gone.
///
/// The column 0 <= x <= L, 0 <= y <= H stands on a floor against a wall at x = 0; its top and its right face are free.
/// Its water is at rest, and so the pressure is harmonic. Two series of it, each fast where the other is slow:
///
/// @f[ \frac{p}{\rho g} = H - y - \sum_n \frac{2}{H k_n^2} \cos k_n y \, \frac{\cosh k_n x}{\cosh k_n L}
///     = \sum_n \frac{2 (-1)^n}{L q_n^2} \cos q_n x \, \frac{\sinh q_n (H - y)}{\cosh q_n H}, \qquad
///     k_n = \frac{(n + \frac12) \pi}{H}, \; q_n = \frac{(n + \frac12) \pi}{L} @f]
///
/// At the toe (L, 0) the acceleration is infinite like the logarithm of the distance; the pressure is continuous.
///
/// When not to use it: any later instant.
///
/// Reference: the two separations of variables; the problem is that of Pohle, The Lagrangian equations of
/// hydrodynamics: solutions which are analytic functions of the time (1950), as told by Stoker, Water Waves (1957),
/// 12.1.
#pragma once

#include <cmath>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class ReleasedColumn {
 public:
  /// @param length, height [m];  @param gravity [m/s^2];  @param density [kg/m^3]. Throws std::invalid_argument.
  ReleasedColumn(double length, double height, double gravity = 1, double density = 1);

  /// Pressure [Pa]. Throws OutsideFluid.
  [[nodiscard]] double pressure(double x, double y) const;
  /// p + rho g y [Pa], with the floor for the level.
  [[nodiscard]] double dynamic_pressure(double x, double y) const { return pressure(x, y) + weight_ * y; }

  /// Of the pressure, relative to rho g H.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double across(double x, double y) const;  ///< p/(rho g) by the first series
  [[nodiscard]] double along(double x, double y) const;   ///< and by the second

  double length_, height_, weight_;
};

}  // namespace seiche::exact
