/// Standing wave of finite amplitude over a flat bottom, second order in amplitude (frequency: third).
///
/// With k = g = 1, depth h, w^2 = tanh h, theta = omega t, e = k amplitude the coefficient of cos x at first order:
///
///     eta = e cos x cos theta + (e^2/8) (w^2 + w^-2 + (3 w^-6 - w^-2) cos 2 theta) cos 2x
///     phi = -(e/w) C1(y) cos x sin theta + e^2 ([3 (w^8 - 1)/(16 w^7)] C2(y) cos 2x sin 2 theta
///           + [(3 w^4 + 1)/(16 w^3)] sin 2 theta + [(w^4 - 1)/(8 w^3)] theta),   Cn(y) = cosh n(y + h)/cosh n h
///     omega = w + (e^2/2) omega_2,   omega_2 = (9 w^-7 - 12 w^-3 - 3 w - 2 w^5)/32
///
/// At greatest elevation (t = 0) the surface is at rest: eta = e cos x + e^2 B cos 2x, B = (w^2 + 3 w^-6)/8. The
/// frequency rises with amplitude in water shallower than k h = 1.0581 (wavelength 5.938 depths) and falls in deeper
/// water, to omega_2 = -1/4. Over infinite depth the second-order pressure does not fade with depth.
///
/// When not to use it: as a profile closer than O(e^3), or with a dimple in the trough, 4 B e > 1 (refused).
///
/// References: Tadjbakhsh and Keller, Standing surface waves of finite amplitude, J. Fluid Mech. 8 (1960) 442; Fultz,
/// An experimental note on finite-amplitude standing gravity waves, J. Fluid Mech. 13 (1962) 193 (the critical depth).
#pragma once

#include <cmath>
#include <numbers>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class StandingWave {
 public:
  /// @param amplitude   first-order coefficient of cos(k x) [m], at most wavelength/(8 pi B)
  /// @param wavelength  [m]: between walls a half-wave, x = 0 at one;  @param depth [m], may be infinite
  /// @param gravity     [m/s^2]
  /// Throws std::invalid_argument.
  StandingWave(double amplitude, double wavelength, double depth, double gravity);

  /// Elevation above the still level [m].
  [[nodiscard]] double elevation(double x, double t) const;
  /// Potential [m^2/s], velocity [m/s], pressure over density [m^2/s^2] at -depth <= y <= max(0, elevation): the
  /// formulas above differentiated, not expanded again. Throw OutsideFluid.
  [[nodiscard]] double potential(double x, double y, double t) const;
  [[nodiscard]] Velocity velocity(double x, double y, double t) const;
  [[nodiscard]] double pressure(double x, double y, double t) const;

  [[nodiscard]] double wavenumber() const { return wavenumber_; }
  [[nodiscard]] double relative_depth() const { return kh_; }  ///< k h
  [[nodiscard]] double frequency() const {
    return std::sqrt(gravity_ * wavenumber_) * (w_ + 0.5 * steepness_ * steepness_ * frequency_correction(kh_));
  }
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / frequency(); }

  /// sqrt(tanh k h), omega_2 and B for a depth of k h = kh > 0, infinity included.
  static double linear_frequency(double kh);
  static double frequency_correction(double kh);
  static double second_harmonic(double kh);
  /// k h at which omega_2 = 0, and the wavelength in depths there.
  static double critical_depth();
  static double critical_wavelength() { return 2 * std::numbers::pi / critical_depth(); }

  [[nodiscard]] double uncertainty() const { return 40 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  /// x, y, t in units 1/k, 1/k, 1/omega.
  struct Place {
    double x, y, theta;
  };
  [[nodiscard]] Place inside(double x, double y, double t) const;

  double wavenumber_, gravity_, kh_, steepness_, w_;
};

}  // namespace seiche::exact
