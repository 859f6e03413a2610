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
#include <optional>

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

/// Standing wave of finite amplitude of the dispersive shallow-water model over a flat bottom, in the limit of fine
/// spacing: third-order frequency, second-order motion.
///
/// With g = H = 1, x = a + xi(a, t), J = x_a = 1 + q, depth 1/J, the model's Lagrangian per unit of label is
///
///     xi_t^2/2 + (alpha/2) J_t^2/J^4 - 1/(2 J) - (gamma/2) J_a^2/J^n,   n = s + 5
///
/// (the last term is the added energy (gamma/2) int h^s h_x^2 dx of surface slopes, h depth). Averaged over
///
///     q = -e cos(k a) cos(theta) + e^2 (B0 + B2 cos(2 theta)) cos(2 k a),   theta = Omega t,
///
/// e amplitude of the first harmonic of the elevation over depth, and made stationary in B0, B2 and e, with
/// kappa = k H, nu = omega^2 H/g = kappa^2 (1 + gamma kappa^2)/(1 + alpha kappa^2),
///
///     Omega = omega (1 + C e^2),   C = -8 N/(1 + gamma kappa^2)
///     N = c0^2/(4 (1 + 4 gamma kappa^2)) - c2^2 (1 + alpha kappa^2)/(6 (alpha - gamma) kappa^2)
///         + (15/64) alpha nu - 9/128 - (3/256) gamma n (n + 1) kappa^2
///     c0 = (3/8) (1 + n gamma kappa^2) - alpha nu/2,   c2 = (3/16) (1 + n gamma kappa^2) - (3/4) alpha nu
///     B0 = c0/(1 + 4 gamma kappa^2),   B2 = -(2/3) c2 (1 + alpha kappa^2)/((alpha - gamma) kappa^2)
///
/// For gamma = 0: C = -(59 alpha^3 kappa^6 + 27 alpha^2 kappa^4 - 3 alpha kappa^2 - 3)/(64 alpha kappa^2
/// (1 + alpha kappa^2)^2), zero at alpha kappa^2 = 0.29573. Water itself has the zero at kappa = 1.0581
/// (standing_wave.hpp).
///
/// When not to use it: coarse spacing (error O(spacing^2)), amplitudes at which e^4 counts.
///
/// References: Frank, Discrete models of incompressible fluids (1994), ch. 3; Whitham, Linear and nonlinear waves
/// (1974), ch. 14 (averaged Lagrangian); Clamond, Dutykh and Mitsotakis, Conservative modified Serre-Green-Naghdi
/// equations with improved dispersion characteristics, Commun. Nonlinear Sci. Numer. Simul. 45 (2017) 245 (gamma).
class DispersiveStandingWave {
 public:
  struct Parameters {
    double alpha = 1.0 / 3;      ///< share of the vertical motion in the kinetic energy
    double gamma = 0;            ///< added potential energy of slopes, 0 <= gamma < alpha
    double weight_exponent = 0;  ///< s: that energy is weighted with (h/H)^s
  };

  /// @param amplitude   of the first harmonic of the elevation [m]; labels must not cross
  /// @param wavelength  [m]: between walls a half-wave, a = 0 at one;  @param depth H [m];  @param gravity [m/s^2]
  /// Throws std::invalid_argument.
  DispersiveStandingWave(double amplitude, double wavelength, double depth, double gravity,
                         const Parameters& parameters);
  DispersiveStandingWave(double amplitude, double wavelength, double depth, double gravity)
      : DispersiveStandingWave(amplitude, wavelength, depth, gravity, Parameters{}) {}

  /// Omega [1/s] and the period [s].
  [[nodiscard]] double frequency() const;
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / frequency(); }
  /// C of this wave.
  [[nodiscard]] double correction() const { return frequency_correction(wavenumber_ * depth_, parameters_); }
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  /// Place [m] of a label, to second order; at rest at t = 0, crest at a = 0.
  [[nodiscard]] double position(double label, double t) const;

  /// C for kH = kh: relative change of frequency over the square of amplitude/depth.
  static double frequency_correction(double kh, const Parameters& parameters);
  /// Smallest kH at which C = 0 (none below 6: empty), and the wavelength in depths there.
  static std::optional<double> critical_depth(const Parameters& parameters);
  static std::optional<double> critical_wavelength(const Parameters& parameters);
  /// Exponent s with which C = 0 at kH = kh: the root of smaller magnitude; empty if there is none or gamma = 0.
  static std::optional<double> exponent_for_critical_depth(double kh, double alpha, double gamma);

  [[nodiscard]] double uncertainty() const { return 40 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  Parameters parameters_;
  double wavenumber_, gravity_, depth_, relative_amplitude_;
};

}  // namespace seiche::exact
