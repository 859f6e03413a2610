/// How a wave of wavenumber k fades with depth, for any depth h, infinity included: no hyperbolic function of k h
/// itself, which overflows.
///
/// Dispersion of small waves over a flat bottom: the exact law and those of the Boussinesq-type models.
///
/// With nu = omega^2 H/g and kappa = k H (H still depth):
///
///     Airy                                     nu = kappa tanh kappa
///     Peregrine, Serre, Green-Naghdi           nu = kappa^2/(1 + alpha kappa^2),  alpha = 1/3
///     Nwogu                                    nu = kappa^2 (1 - (A + 1/3) kappa^2)/(1 - A kappa^2),  A = -0.39
///     Madsen and Sorensen                      nu = kappa^2 (1 + B kappa^2)/(1 + (B + 1/3) kappa^2),  B = 1/15
///
/// B = 1/15 (and A = -2/5) is the [2/2] Pade approximant of kappa tanh kappa. Phase speed omega/k, group speed
/// d omega/dk in closed form. The law of a chain of markers is FrankDispersion (lattice_dispersion.hpp).
///
/// When not to use it: waves of finite amplitude (StandingWave, SolitaryWave), currents, surface tension.
///
/// References: Airy, Tides and waves (1845); Peregrine, Long waves on a beach, J. Fluid Mech. 27 (1967) 815; Green and
/// Naghdi, J. Fluid Mech. 78 (1976) 237; Madsen and Sorensen, Coastal Eng. 18 (1992) 183; Nwogu, Alternative form of
/// Boussinesq equations, J. Waterway Port Coastal Ocean Eng. 119 (1993) 618.
///
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

#include <cmath>
#include <numbers>
#include <variant>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

/// cosh(k (y + h))/cosh(k h): 1 at y = 0; exp(k y) over infinite depth.
inline double cosh_profile(double k, double y, double depth) {
  return std::exp(k * y) * (1 + std::exp(-2 * k * (y + depth))) / (1 + std::exp(-2 * k * depth));
}

/// sinh(k (y + h))/cosh(k h): tanh(k h) at y = 0, 0 on the bottom.
inline double sinh_profile(double k, double y, double depth) {
  return -std::exp(k * y) * std::expm1(-2 * k * (y + depth)) / (1 + std::exp(-2 * k * depth));
}

/// Water at rest: gravity [m/s^2] and depth [m].
struct Water {
  double gravity, depth;
};

/// What a wave is known by.
struct Wavelength {
  double value;  ///< [m]
};
struct Period {
  double value;  ///< [s]
};
struct AngularFrequency {
  double value;  ///< [1/s]
};
using WaveScale = std::variant<Wavelength, Period, AngularFrequency>;

/// Wave of potential theory, depth up to infinity.
class AiryDispersion {
 public:
  /// @param gravity [m/s^2];  @param depth [m], may be infinite. Throws std::invalid_argument.
  explicit AiryDispersion(double gravity, double depth);

  /// Angular frequency [1/s], phase and group speed [m/s] of wavenumber k > 0 [1/m].
  [[nodiscard]] double frequency(double k) const;
  [[nodiscard]] double phase_speed(double k) const;
  [[nodiscard]] double group_speed(double k) const;
  /// Wavenumber [1/m] of the angular frequency omega > 0, by Newton's method to round-off.
  [[nodiscard]] double wavenumber(double omega) const;
  /// Wavenumber [1/m] and angular frequency [1/s] of a wave, whatever it is known by.
  [[nodiscard]] double wavenumber_of(const WaveScale& wave) const;
  [[nodiscard]] double frequency_of(const WaveScale& wave) const;

  [[nodiscard]] double gravity() const { return gravity_; }
  [[nodiscard]] double depth() const { return depth_; }

  [[nodiscard]] double uncertainty() const { return 10 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_, depth_;
};

/// Law of a Boussinesq-type model, nu = kappa^2 (1 + numerator kappa^2)/(1 + denominator kappa^2).
class RationalDispersion {
 public:
  /// @param numerator >= 0, @param denominator > numerator, else short waves are unstable or faster than long ones.
  /// Throws std::invalid_argument.
  RationalDispersion(double gravity, double depth, double numerator, double denominator);

  /// Peregrine's Boussinesq equations, Serre, Green-Naghdi; alpha multiplies the vertical kinetic energy.
  static RationalDispersion green_naghdi(double gravity, double depth, double alpha = 1.0 / 3);
  /// @param a  z (z/2 + 1) of the reference level z in depths, -1/2 <= a <= -1/3
  static RationalDispersion nwogu(double gravity, double depth, double a = -0.39);
  static RationalDispersion madsen_sorensen(double gravity, double depth, double b = 1.0 / 15);

  /// Angular frequency [1/s], phase and group speed [m/s] of wavenumber k > 0 [1/m].
  [[nodiscard]] double frequency(double k) const { return k * phase_speed(k); }
  [[nodiscard]] double phase_speed(double k) const;
  [[nodiscard]] double group_speed(double k) const;
  /// Wavenumber [1/m] of the angular frequency omega > 0; with numerator 0 there is none at or above
  /// highest_frequency().
  [[nodiscard]] double wavenumber(double omega) const;
  /// Limit of the frequency of short waves [1/s], sqrt(g/(denominator H)) with numerator 0, else infinite.
  [[nodiscard]] double highest_frequency() const;

  [[nodiscard]] double uncertainty() const { return 10 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_, depth_, numerator_, denominator_;
};

class AiryWave {
 public:
  /// @param amplitude   half the height [m], at most that of Miche's highest wave, 0.071 wavelength tanh(k depth)
  /// @param wave        what it is known by;  @param water  its depth may be infinite
  /// Throws std::invalid_argument.
  AiryWave(double amplitude, const WaveScale& wave, const Water& water);

  [[nodiscard]] double elevation(double x, double t) const;
  /// Velocity [m/s] and pressure over density [m^2/s^2] at -depth <= y <= max(0, elevation). Throw OutsideFluid.
  [[nodiscard]] Velocity velocity(double x, double y, double t) const;
  [[nodiscard]] double pressure(double x, double y, double t) const;

  [[nodiscard]] double wavenumber() const { return wavenumber_; }
  [[nodiscard]] double frequency() const { return frequency_; }
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / frequency_; }
  [[nodiscard]] double phase_speed() const { return frequency_ / wavenumber_; }
  [[nodiscard]] double group_speed() const { return law_.group_speed(wavenumber_); }

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  void require_inside(double x, double y, double t) const;

  AiryDispersion law_;
  double amplitude_, wavenumber_, frequency_;
};

}  // namespace seiche::exact
