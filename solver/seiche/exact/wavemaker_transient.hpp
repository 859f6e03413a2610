/// Waves of a piston or flap that starts from rest: the exact linear transient.
///
/// The paddle moves by (S/2) f(y) sin(omega t) from t = 0 (its velocity jumps to omega S/2), f = 1 (piston) or 1 + y/d
/// (flap hinged at the bottom). In units of d and sqrt(d/g), with omega_k^2 = k tanh k,
///
///     eta(x, t) = (2/pi) int_0^inf q(k) B(k, t) cos(kx) dk,
///     q = (omega S/2) tanh(k)/k  (piston),   (omega S/2) [tanh(k)/k - (1 - 1/cosh k)/k^2]  (flap),
///     B = [omega sin(omega t) - omega_k sin(omega_k t)]/(omega^2 - omega_k^2).
///
/// The integrand falls only as k^{-3/2} and oscillates. It is integrated by Gauss panels up to a k where tanh k = 1 to
/// round-off; from there it is elementary and each of its oscillating parts is integrated along a path in the complex
/// plane on which it decays, for the group that travels past x at this moment through its saddle point k = t^2/(4 x^2).
///
/// When not to use it: strokes or waves that are not small; after the wave has returned from the end of a flume.
///
/// References: Kennard, Generation of surface waves by a moving partition, Quart. Appl. Math. 7 (1949) 303; Joo,
/// Schultz and Messiter, An analysis of the initial-value wavemaker problem, J. Fluid Mech. 214 (1990) 161.
#pragma once

#include "seiche/exact/wavemaker.hpp"

namespace seiche::exact {

class WavemakerTransient {
 public:
  /// @param frequency  angular frequency omega [1/s];  @param stroke  S at the still-water level [m]
  /// Throws std::invalid_argument.
  WavemakerTransient(Paddle paddle, double gravity, double depth, double frequency, double stroke = 1);
  static WavemakerTransient with_period(Paddle paddle, double gravity, double depth, double period, double stroke = 1);

  /// Surface elevation [m] at x >= 0, t >= 0. Throws OutsideFluid behind the paddle.
  [[nodiscard]] double elevation(double x, double t) const;
  /// Rate of rise of the surface just after the start, d eta/dt(x, 0+) [m/s], in closed form for the piston:
  /// (omega S/pi) ln coth(pi x/(4 d)).
  [[nodiscard]] double initial_rate_of_piston(double x) const;
  /// The motion that is approached.
  [[nodiscard]] const Wavemaker& steady() const { return steady_; }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double scaled_elevation(double x, double t, double split) const;
  [[nodiscard]] double up_to(double split, double x, double t) const;
  [[nodiscard]] double beyond(double split, double x, double t) const;

  Wavemaker steady_;
  double time_unit_;  ///< sqrt(d/g)
  double omega_;      ///< scaled
};

}  // namespace seiche::exact
