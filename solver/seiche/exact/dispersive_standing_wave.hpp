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
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

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
