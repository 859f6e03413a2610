/// A steep wave that overturns: fully nonlinear potential flow, periodic, over a flat bottom or in deep water.
///
/// At t = 0 the surface is eta = amplitude cos kx with the surface potential of the linear wave of that amplitude
/// travelling to +x (k = 2 pi/wavelength, units of 1/k and g in the formulas):
///
///     phi = (A/w) cosh(y + h)/cosh(h) sin x at y = eta,   w = sqrt(tanh h).
///
/// Too steep to be a travelling wave, it breaks. Cauchy's integral gives the velocity of the surface with spectral
/// accuracy (overturning/surface_velocity.hpp); markers move with the water (overturning/evolution.hpp) until the jet
/// touches the water ahead. Volume, energy and impulse are conserved by the motion, and measured.
///
/// When not to use it: after touch-down; waves that do not break (travelling waves: stokes_wave.hpp); near touch-down
/// for more digits than uncertainty(t) says.
///
/// References: Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350
/// (1976) 1; Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123
/// (1982) 477.
#pragma once

#include <limits>
#include <numbers>
#include <optional>

#include "seiche/exact/overturning/moving_surface.hpp"
#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class OverturningWave : public overturning::MovingSurface {
 public:
  struct Parameters {
    double amplitude = 0.5;                                  ///< [m]; k amplitude in (0, 1], amplitude < depth
    double wavelength = 2 * std::numbers::pi;                ///< [m]
    double depth = std::numeric_limits<double>::infinity();  ///< [m]; infinite for deep water
    double gravity = 1;                                      ///< [m/s^2]
    std::size_t markers = 512;                               ///< even, at least 64
    double tolerance = 2e-11;                                ///< of a time step, in units of 1/k
    std::optional<double> last_time{};                       ///< [s]; one period of the linear wave if not given
  };

  /// Computes the motion until last_time or until it ends by itself.
  /// Throws std::invalid_argument.
  explicit OverturningWave(const Parameters& parameters);

  static Provenance provenance();
  /// Distance of the surface from a second computation with three quarters of the markers and ten times the tolerance,
  /// relative to the amplitude; at the time well_resolved_until(), a quarter of the time to the first vertical tangent
  /// after it, if none is given. Takes as long as that computation.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] double uncertainty(double t) const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  Parameters parameters_;
};

}  // namespace seiche::exact
