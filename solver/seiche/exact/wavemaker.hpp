/// Waves of a piston or a bottom-hinged flap in linear theory: stroke, progressive wave, near field.
///
/// The paddle at x = 0 moves by (S/2) f(y) sin(omega t), f = 1 (piston) or 1 + y/d (flap, hinged at the bottom), in
/// water of depth d. In units of d and sqrt(d/g), nu = omega^2, the modes are k tanh k = nu and k_n tan k_n = -nu, (n -
/// 1/2) pi < k_n < n pi, and
///
///     eta = (S/2) [ (H/S) cos(kx - omega t) + sum C_n e^{-k_n x} sin(omega t) ],
///     piston  H/S = 4 sinh^2 k/(sinh 2k + 2k),                        C_n = 2 nu^2/(k_n (k_n^2 + nu^2 - nu)),
///     flap    H/S = 4 (sinh k/k)(k sinh k - cosh k + 1)/(sinh 2k + 2k),
///             C_n = 2 nu ((-1)^n rho_n - (1 - nu) k_n)/(k_n^2 (rho_n^2 - nu)),   rho_n^2 = k_n^2 + nu^2.
///
/// The C_n are the textbook forms with sin k_n and cos k_n replaced by the mode's equation: no cancellation at any n.
///
/// When not to use it: the start from rest (WavemakerTransient); strokes or waves that are not small.
///
/// References: Havelock, Forced surface-waves on water, Phil. Mag. 8 (1929) 569; Biesel and Suquet (1951); Dean and
/// Dalrymple, Water Wave Mechanics for Engineers and Scientists (1991), ch. 6.
///
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

#include <cmath>
#include <numbers>
#include <string_view>

#include "seiche/exact/dispersion.hpp"

namespace seiche::exact {

enum class Paddle { piston, flap };
std::string_view name_of(Paddle paddle);

class Wavemaker {
 public:
  /// @param wave  the progressive wave;  @param stroke  S at the still-water level [m], of either sign
  /// Throws std::invalid_argument.
  Wavemaker(Paddle paddle, const Water& water, const WaveScale& wave, double stroke = 1);
  /// The stroke that makes a progressive wave of this height [m].
  [[nodiscard]] double stroke_for(double wave_height) const { return wave_height / height_per_stroke_; }

  [[nodiscard]] double frequency() const { return frequency_; }
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / frequency_; }
  /// Wavenumber [1/m] and wavelength [m] of the progressive wave.
  [[nodiscard]] double wavenumber() const { return wavenumber_ / depth_; }
  [[nodiscard]] double wavelength() const { return 2 * std::numbers::pi / wavenumber(); }
  /// H/S, and the height of the progressive wave [m].
  [[nodiscard]] double height_per_stroke() const { return height_per_stroke_; }
  [[nodiscard]] double wave_height() const { return height_per_stroke_ * stroke_; }
  /// Evanescent mode n >= 1: decay rate k_n [1/m] and coefficient C_n.
  [[nodiscard]] double evanescent_wavenumber(long n) const;
  [[nodiscard]] double coefficient(long n) const;

  /// Surface elevation [m] of the steady motion at x >= 0, near field included. Throws OutsideFluid behind the paddle.
  [[nodiscard]] double elevation(double x, double t) const;
  /// The progressive wave alone.
  [[nodiscard]] double progressive(double x, double t) const {
    return 0.5 * stroke_ * height_per_stroke_ * std::cos(wavenumber_ * x / depth_ - frequency_ * t);
  }

  [[nodiscard]] Paddle paddle() const { return paddle_; }
  [[nodiscard]] double gravity() const { return gravity_; }
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] double stroke() const { return stroke_; }

  [[nodiscard]] double uncertainty() const { return 1e-13; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double scaled_wavenumber(double n) const;
  [[nodiscard]] double smooth_part(double k) const;
  [[nodiscard]] double alternating_part(double k) const;
  template <class Weight>
  [[nodiscard]] double sum_of_modes(Weight weight, double decay, long first_omitted) const;

  Paddle paddle_;
  double gravity_, depth_, frequency_, stroke_;
  double nu_;          ///< omega^2 d/g
  double wavenumber_;  ///< k d
  double height_per_stroke_;
};

class WavemakerTransient {
 public:
  /// @param wave  the one that is approached;  @param stroke  S at the still-water level [m]
  /// Throws std::invalid_argument.
  WavemakerTransient(Paddle paddle, const Water& water, const WaveScale& wave, double stroke);

  /// Surface elevation [m] at x >= 0, t >= 0. Throws OutsideFluid behind the paddle.
  [[nodiscard]] double elevation(double x, double t) const;
  /// Rate of rise of the surface just after the start, d eta/dt(x, 0+) [m/s], in closed form for the piston:
  /// (omega S/pi) ln coth(pi x/(4 d)).
  [[nodiscard]] double initial_rate_of_piston(double x) const;
  /// The motion that is approached.
  [[nodiscard]] const Wavemaker& steady() const { return steady_; }

  [[nodiscard]] double uncertainty() const { return 1e-12; }
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
