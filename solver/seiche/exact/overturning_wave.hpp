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
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

namespace overturning {
class Evolution;
}

class OverturningWave {
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

  /// Points of the surface along one wavelength, in the order of the surface, with potential [m^2/s] and velocity
  /// [m/s].
  struct Profile {
    double time = 0;
    std::vector<double> x, y, potential, u, v;
  };
  /// At the markers. Throws std::invalid_argument for a time before 0 or after last_time, Divergence for one after the
  /// motion ended.
  [[nodiscard]] Profile profile(double t) const;
  /// At points of equal arc length of the trigonometric interpolant, the first and last one wavelength apart.
  [[nodiscard]] Profile profile(double t, std::size_t points) const;

  /// Highest and lowest elevation [m].
  struct Extremes {
    double highest, lowest;
  };
  [[nodiscard]] Extremes extremes(double t) const;

  /// Nose of the jet and throat of the cavity below it, where the surface is vertical [m], and the least distance
  /// between the outer half of the jet and the water ahead [m]; none while the surface is a graph.
  struct Jet {
    double nose_x, nose_y, throat_x, throat_y, gap;
  };
  [[nodiscard]] std::optional<Jet> jet(double t) const;

  /// First time with a vertical tangent [s]; none if not before end_time().
  [[nodiscard]] std::optional<double> vertical_tangent_time() const { return vertical_tangent_time_; }
  /// When the gap closes [s]: extrapolated linearly from its last values that the markers resolve, less than a
  /// twentieth of a wavelength apart; none if the gap is not that small in the computed motion.
  [[nodiscard]] std::optional<double> touch_down_time() const { return touch_down_time_; }
  /// Last time computed [s]: last_time, or when the time step or the resolution collapsed.
  [[nodiscard]] double end_time() const;
  /// Why the motion ended before last_time; empty if it did not.
  [[nodiscard]] std::string ending_reason() const;
  [[nodiscard]] std::size_t steps() const;

  /// Per wavelength, for density 1: volume above the level at rest [m^2], kinetic and potential energy [m^4/s^2],
  /// horizontal impulse [m^3/s].
  struct Integrals {
    double volume, kinetic_energy, potential_energy, impulse;
  };
  [[nodiscard]] Integrals integrals(double t) const;

  static Provenance provenance();
  /// Distance of the surface from a second computation with three quarters of the markers and ten times the tolerance,
  /// relative to the amplitude; at the time well_resolved_until() if none is given. Takes as long as that computation.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] double uncertainty(double t) const;
  /// A quarter of the time to the first vertical tangent after it [s]: the jet is then developed, and not yet thin.
  [[nodiscard]] double well_resolved_until() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double scaled_time(double t) const;
  void find_touch_down();

  Parameters parameters_;
  double length_;    ///< 1/k
  double time_;      ///< 1/sqrt(g k)
  double velocity_;  ///< sqrt(g/k)
  double last_time_;
  std::shared_ptr<const overturning::Evolution> evolution_;
  std::optional<double> vertical_tangent_time_;
  std::optional<double> touch_down_time_;
};

}  // namespace seiche::exact
