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
#pragma once

#include <string_view>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

enum class Paddle { piston, flap };
std::string_view name_of(Paddle paddle);

class Wavemaker {
 public:
  /// @param frequency  angular frequency omega [1/s];  @param stroke  S at the still-water level [m], of either sign
  /// Throws std::invalid_argument.
  Wavemaker(Paddle paddle, double gravity, double depth, double frequency, double stroke = 1);
  static Wavemaker with_period(Paddle paddle, double gravity, double depth, double period, double stroke = 1);
  static Wavemaker with_wavelength(Paddle paddle, double gravity, double depth, double wavelength, double stroke = 1);
  /// The stroke that makes a progressive wave of this height [m].
  [[nodiscard]] double stroke_for(double wave_height) const { return wave_height / height_per_stroke_; }

  [[nodiscard]] double frequency() const { return frequency_; }
  [[nodiscard]] double period() const;
  /// Wavenumber [1/m] and wavelength [m] of the progressive wave.
  [[nodiscard]] double wavenumber() const { return wavenumber_ / depth_; }
  [[nodiscard]] double wavelength() const;
  /// H/S, and the height of the progressive wave [m].
  [[nodiscard]] double height_per_stroke() const { return height_per_stroke_; }
  [[nodiscard]] double wave_height() const { return height_per_stroke_ * stroke_; }
  /// Evanescent mode n >= 1: decay rate k_n [1/m] and coefficient C_n.
  [[nodiscard]] double evanescent_wavenumber(long n) const;
  [[nodiscard]] double coefficient(long n) const;

  /// Surface elevation [m] of the steady motion at x >= 0, near field included. Throws OutsideFluid behind the paddle.
  [[nodiscard]] double elevation(double x, double t) const;
  /// The progressive wave alone.
  [[nodiscard]] double progressive(double x, double t) const;
  /// Position of the paddle at the still-water level [m].
  [[nodiscard]] double paddle_position(double t) const;

  [[nodiscard]] Paddle paddle() const { return paddle_; }
  [[nodiscard]] double gravity() const { return gravity_; }
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] double stroke() const { return stroke_; }

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double scaled_wavenumber(double n) const;
  [[nodiscard]] double smooth_part(double k) const;
  [[nodiscard]] double alternating_part(double k) const;
  template <class Weight>
  [[nodiscard]] double sum_of_modes(Weight weight, double decay, long first_omitted) const;

  Paddle paddle_;
  double gravity_;
  double depth_;
  double frequency_;
  double stroke_;
  double nu_;          ///< omega^2 d/g
  double wavenumber_;  ///< k d
  double height_per_stroke_;
};

}  // namespace seiche::exact
