/// Periodic progressive gravity wave (Stokes wave) of the full Euler equations, finite or infinite depth, to round-off.
///
/// In the frame of the wave and in units of 1/k (k = 2 pi/wavelength), sqrt(gravity/k) and of the phase speed c, with
/// the complex potential W = phi + i psi of period 2 pi, dW/dz = exp(tau - i theta), q = exp(tau), psi = 0 on the
/// surface and -d on the bottom (d the conformal depth, infinite in deep water):
///
///     theta = T tau,   T with the symbol -i tanh(k d),
///     c^2 q^2/2 + y = B   (Bernoulli),   c^2/2 d(q^2)/dphi + sin(theta)/q = 0   (its derivative along the surface),
///     int cos(theta)/q dphi = 2 pi,   c^2 (q_trough^2 - q_crest^2)/2 = wave height.
///
/// c is the speed in the frame where the mean Eulerian velocity below the troughs is zero (Stokes's first definition).
/// Coordinates: y = 0 mean level, bottom y = -mean_depth, crest at x = 0 travelling to +x. Densities of energy and of
/// impulse are for density 1, averaged over a wavelength.
///
/// When not to use it: k depth < 0.2 (the crests are solitary waves: SolitaryWave); irregular or short-crested waves.
///
/// References: Schwartz, Computer extension and analytic continuation of Stokes' expansion, J. Fluid Mech. 62 (1974)
/// 553; Cokelet, Steep gravity waves in water of arbitrary uniform depth, Phil. Trans. R. Soc. A 286 (1977) 183;
/// Longuet-Higgins, Integral properties of periodic gravity waves of finite amplitude, Proc. R. Soc. A 342 (1975) 157;
/// Dyachenko, Lushnikov & Korotkevich, Branch cuts of Stokes wave on deep water, Stud. Appl. Math. 137 (2016) 419.
#pragma once

#include <limits>
#include <memory>

#include "seiche/exact/conformal_wave.hpp"

namespace seiche::exact {

/// The solved wave in units of 1/k and sqrt(gravity/k).
class StokesSurface : public ConformalSurface {
 public:
  explicit StokesSurface(ConformalSolution solution);
  /// With the mean depth in place of the conformal depth: secant iteration.
  static StokesSurface with_mean_depth(WaveCrest crest, double mean_depth, Resolution resolution);

  [[nodiscard]] double bernoulli() const { return bernoulli_; }
  [[nodiscard]] double trough() const { return elevation_[elevation_.size() - 1]; }
  [[nodiscard]] double potential(double x) const;

 private:
  [[nodiscard]] Point point(double label) const override;
  [[nodiscard]] std::complex<double> pole(std::complex<double> z) const override;
  [[nodiscard]] std::complex<double> pole_slope(std::complex<double> z) const override {
    return bottom_matters() ? std::complex<double>(0, 1) * std::sin(z + std::complex<double>(0, depth_)) : 1;
  }
  [[nodiscard]] double reduced(double x) const override { return std::remainder(x, 2 * std::numbers::pi); }
  [[nodiscard]] bool bottom_matters() const { return depth_ < 19; }  // exp(-2 k h) is below round-off

  double bernoulli_ = 0;
};

class StokesWave : public ScaledWave<StokesSurface> {
 public:
  static constexpr double deep = std::numeric_limits<double>::infinity();

  /// @param amplitude   half of the height from trough to crest [m]; above the limiting wave it throws
  ///                    std::invalid_argument that names the steepest wave reached
  /// @param wavelength  [m];  @param mean_depth  [m], StokesWave::deep for infinite depth; k mean_depth >= 0.2
  StokesWave(double amplitude, double wavelength, double mean_depth, double gravity, Resolution resolution = {});
  /// With the conformal depth (flux/c, [m]) in place of the mean depth: one solution less deep, no outer iteration.
  static StokesWave from_conformal_depth(double amplitude, double wavelength, double conformal_depth, double gravity,
                                         Resolution resolution = {});
  /// The wave whose water moves backwards at the crest, seen from the wave, with crest_speed times the phase speed:
  /// [0.0015, 0.9999], 0 in the limiting wave.
  static StokesWave from_crest_speed(double crest_speed, double wavelength, double conformal_depth, double gravity,
                                     Resolution resolution = {});

  /// Half height [m].
  [[nodiscard]] double amplitude() const { return 0.5 * (crest_elevation() - trough_elevation()); }
  [[nodiscard]] double wavelength() const { return 2 * std::numbers::pi / wavenumber_; }  ///< [m]
  [[nodiscard]] double wavenumber() const { return wavenumber_; }                         ///< [1/m]
  /// Mean and conformal depth [m], infinite in deep water.
  [[nodiscard]] double mean_depth() const { return surface_->depth() / wavenumber_; }
  [[nodiscard]] double conformal_depth() const { return surface_->solution().nodes->depth() / wavenumber_; }
  [[nodiscard]] double phase_speed() const { return speed(); }  ///< c [m/s]
  /// B = q^2/2 + g y on the surface, q in the frame of the wave, y from the mean level [m^2/s^2].
  [[nodiscard]] double bernoulli_constant() const { return celerity_ * celerity_ * surface_->bernoulli(); }

  [[nodiscard]] double crest_elevation() const { return surface_->crest() / wavenumber_; }    ///< [m]
  [[nodiscard]] double trough_elevation() const { return surface_->trough() / wavenumber_; }  ///< [m], negative
  /// u at the crest [m/s].
  [[nodiscard]] double crest_velocity() const { return -phase_speed() * std::expm1(surface_->solution().tau[0]); }
  /// I, mean of the depth-integrated u [m^2/s].
  [[nodiscard]] double impulse() const { return celerity_ / wavenumber_ * surface_->integrals().impulse; }
  /// T, mean of the depth-integrated (u^2 + v^2)/2, and V, mean of g eta^2/2 [m^3/s^2].
  [[nodiscard]] double kinetic_energy() const {
    return gravity_ / (wavenumber_ * wavenumber_) * surface_->integrals().kinetic_energy;
  }
  [[nodiscard]] double potential_energy() const {
    return gravity_ / (wavenumber_ * wavenumber_) * surface_->integrals().potential_energy;
  }

  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  StokesWave(StokesSurface surface, double wavenumber, double gravity)
      : ScaledWave(std::make_shared<const StokesSurface>(std::move(surface)), wavenumber, gravity) {}
};

}  // namespace seiche::exact
