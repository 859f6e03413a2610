/// Solitary wave of the full Euler equations, irrotational, without surface tension: every amplitude, to round-off.
///
/// In the frame of the wave and in units of the depth, of sqrt(gravity depth) and of the Froude number F = c/sqrt(g h):
/// complex potential W = phi + i psi, dW/dz = exp(tau - i theta), q = exp(tau) the speed and theta the inclination of
/// the surface psi = 0 above the bottom psi = -1,
///
///     theta(phi) = 1/2 PV int tau(phi') / sinh(pi (phi - phi')/2) dphi'    (analytic in the strip, flat bottom),
///     y = F^2 (1 - q^2)/2                                                  (Bernoulli),
///     dy/dphi = sin(theta)/q                                               (the surface is a streamline),
///
/// solved for tau and F^2 by Newton's method on nodes clustered under the crest. Velocities inside are the quotient of
/// two Cauchy sums along the surface and its mirror image in the bottom, accurate up to the surface.
///
/// Two waves share a speed above F = 1.29089 (F is largest at amplitude 0.7959 depth), so that the amplitude, or near
/// the limit the crest speed, is the parameter. Coordinates: y = 0 undisturbed level, bottom y = -depth, crest at x = 0
/// travelling to +x, water at rest far away (laboratory frame). Integrals are for density 1 per unit length of crest.
///
/// When not to use it: viscous or stratified water, surface tension; speeds of a solitary wave of a model equation
/// (Boussinesq, Serre) differ from it by O(a^2) and more.
///
/// References: Longuet-Higgins & Fenton, On the mass, momentum, energy and circulation of a solitary wave II, Proc. R.
/// Soc. A 340 (1974) 471; Hunter & Vanden-Broeck, Accurate computations for steep solitary waves, J. Fluid Mech. 136
/// (1983) 63; Tanaka, The stability of solitary waves, Phys. Fluids 29 (1986) 650; Dutykh & Clamond, Efficient
/// computation of steady solitary gravity waves, Wave Motion 51 (2014) 86.
#pragma once

#include <memory>

#include "seiche/exact/conformal_wave.hpp"

namespace seiche::exact {

/// The solved wave in units of the depth and of sqrt(gravity depth).
class SolitarySurface : public ConformalSurface {
 public:
  /// Throws std::invalid_argument above the limiting wave.
  SolitarySurface(WaveCrest crest, Resolution resolution);

  [[nodiscard]] double decay_rate() const { return decay_rate_; }
  [[nodiscard]] double potential(double x) const;
  [[nodiscard]] double half_width() const;

 private:
  explicit SolitarySurface(ConformalSolution solution);
  [[nodiscard]] Point point(double label) const override;
  [[nodiscard]] std::complex<double> pole(std::complex<double> z) const override;
  /// Of the square of sinh without its factor 2, which cancels.
  [[nodiscard]] std::complex<double> pole_slope(std::complex<double> z) const override {
    return std::complex<double>(0, 1) *
           std::sinh((z + std::complex<double>(0, 1)) * (std::numbers::pi / kernel_period_));
  }

  double decay_rate_;
  double kernel_period_ = 0;     ///< p of the kernel 1/sinh(pi z/p)
  double end_displacement_ = 0;  ///< X(infinity) = C/(2 F); interpolated is X - X(infinity) tanh(s/2)
};

class SolitaryWave : public ScaledWave<SolitarySurface> {
 public:
  /// @param amplitude  crest above the undisturbed level [m], amplitude/depth in [0.001, 0.8331]
  /// Throws std::invalid_argument.
  explicit SolitaryWave(double amplitude, double depth = 1, double gravity = 1, Resolution resolution = {});
  /// The wave whose water moves backwards at the crest, seen from the wave, with crest_speed times the wave's speed:
  /// 1 without a wave, 0 in the limiting one; [3e-4, 0.999].
  static SolitaryWave from_crest_speed(double crest_speed, double depth = 1, double gravity = 1,
                                       Resolution resolution = {});

  [[nodiscard]] double amplitude() const { return depth_ * surface_->crest(); }  ///< [m]
  [[nodiscard]] double depth() const { return depth_; }                          ///< undisturbed [m]
  [[nodiscard]] double froude() const { return surface_->speed(); }              ///< F = c/sqrt(gravity depth)

  /// M = int eta dx [m^2].
  [[nodiscard]] double mass() const { return depth_ * depth_ * surface_->integrals().mass; }
  /// T = 1/2 int int u^2 + v^2 dy dx, V = g/2 int eta^2 dx [m^4/s^2].
  [[nodiscard]] double kinetic_energy() const {
    return gravity_ * std::pow(depth_, 3) * surface_->integrals().kinetic_energy;
  }
  [[nodiscard]] double potential_energy() const {
    return gravity_ * std::pow(depth_, 3) * surface_->integrals().potential_energy;
  }
  /// C = int u dx along any line below the troughs [m^2/s].
  [[nodiscard]] double circulation() const { return celerity_ * depth_ * surface_->integrals().circulation; }
  [[nodiscard]] double impulse() const { return speed() * mass(); }                      ///< I = c M [m^3/s]
  [[nodiscard]] double crest_velocity() const { return speed() * (1 - crest_speed()); }  ///< u at the crest [m/s]
  [[nodiscard]] double half_width() const { return depth_ * surface_->half_width(); }    ///< where eta = a/2 [m]
  /// Rate of decay of the tail, eta ~ exp(-decay_rate |x|) [1/m].
  [[nodiscard]] double decay_rate() const { return surface_->decay_rate() / depth_; }

  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  SolitaryWave(WaveCrest crest, double depth, double gravity, Resolution resolution);

  double depth_;
};

}  // namespace seiche::exact
