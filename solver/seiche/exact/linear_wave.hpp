/// Airy's progressive wave of small amplitude over a flat bottom or over infinite depth.
///
///     eta = a cos(k x - omega t),   omega^2 = g k tanh(k h),   y = 0 still level, y = -h bottom
///     u = a omega cosh(k (y + h))/sinh(k h) cos(k x - omega t),  v = a omega sinh(k (y + h))/sinh(k h) sin(k x - omega
///     t) p = -g y + g a cosh(k (y + h))/cosh(k h) cos(k x - omega t)       (density 1)
///
/// The free-surface conditions hold at y = 0 to first order in the steepness k a; above a trough the formulas are
/// evaluated up to y = 0, where the linear problem is posed.
///
/// When not to use it: steepness beyond a few per cent (StandingWave, Stokes waves), or depth below 1/20 wavelength
/// with amplitude comparable to it (solitary and cnoidal waves).
///
/// References: Airy, Tides and waves (1845); Lamb, Hydrodynamics (1932), sections 228-230; Miche, Mouvements
/// ondulatoires de la mer, Ann. Ponts et Chaussees (1944) (the highest wave).
#pragma once

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/velocity.hpp"

namespace seiche::exact {

class AiryWave {
 public:
  /// @param amplitude   half the height [m], at most that of Miche's highest wave, 0.071 wavelength tanh(k depth)
  /// @param wavelength  [m];  @param depth [m], may be infinite;  @param gravity [m/s^2]
  /// Throws std::invalid_argument.
  AiryWave(double amplitude, double wavelength, double depth, double gravity);

  [[nodiscard]] double elevation(double x, double t) const;
  /// Velocity [m/s] and pressure over density [m^2/s^2] at -depth <= y <= max(0, elevation). Throw OutsideFluid.
  [[nodiscard]] Velocity velocity(double x, double y, double t) const;
  [[nodiscard]] double pressure(double x, double y, double t) const;

  [[nodiscard]] double wavenumber() const { return wavenumber_; }
  [[nodiscard]] double frequency() const { return frequency_; }
  [[nodiscard]] double period() const;
  [[nodiscard]] double phase_speed() const { return frequency_ / wavenumber_; }
  [[nodiscard]] double group_speed() const { return law_.group_speed(wavenumber_); }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  void require_inside(double x, double y, double t) const;

  AiryDispersion law_;
  double amplitude_;
  double wavenumber_;
  double frequency_;
};

}  // namespace seiche::exact
