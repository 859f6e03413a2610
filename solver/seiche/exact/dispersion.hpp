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
/// d omega/dk in closed form. The law of a chain of markers is FrankDispersion (frank_dispersion.hpp).
///
/// When not to use it: waves of finite amplitude (StandingWave, SolitaryWave), currents, surface tension.
///
/// References: Airy, Tides and waves (1845); Peregrine, Long waves on a beach, J. Fluid Mech. 27 (1967) 815; Green and
/// Naghdi, J. Fluid Mech. 78 (1976) 237; Madsen and Sorensen, Coastal Eng. 18 (1992) 183; Nwogu, Alternative form of
/// Boussinesq equations, J. Waterway Port Coastal Ocean Eng. 119 (1993) 618.
#pragma once

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

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

  [[nodiscard]] double gravity() const { return gravity_; }
  [[nodiscard]] double depth() const { return depth_; }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_;
  double depth_;
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
  [[nodiscard]] double frequency(double k) const;
  [[nodiscard]] double phase_speed(double k) const;
  [[nodiscard]] double group_speed(double k) const;
  /// Wavenumber [1/m] of the angular frequency omega > 0; with numerator 0 there is none at or above
  /// highest_frequency().
  [[nodiscard]] double wavenumber(double omega) const;
  /// Limit of the frequency of short waves [1/s], sqrt(g/(denominator H)) with numerator 0, else infinite.
  [[nodiscard]] double highest_frequency() const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_;
  double depth_;
  double numerator_;
  double denominator_;
};

}  // namespace seiche::exact
