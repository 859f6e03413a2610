/// Run-up of a solitary wave on a vertical wall: fully nonlinear potential flow.
///
/// The wave and its mirror image in the wall collide head-on: two solitary waves of the full Euler equations in a
/// periodic channel, so far apart that less than 1e-12 of each is left under the other, moved by Cauchy's integral
/// (overturning/evolution.hpp). Run-up R is the highest elevation of the marker at the wall above the undisturbed
/// level. In units of the depth, for small a:
///
///     R = 2a + a^2/2 + 3a^3/4 + O(a^4)   (Su & Mirie),   R = 2a + a^2/2 + O(a^3)   (Byatt-Smith).
///
/// When not to use it: amplitudes above 0.6 depths, where a thin jet rises along the wall; breaking waves.
///
/// References: Byatt-Smith, An integral equation for unsteady surface waves and a comment on the Boussinesq equation,
/// J. Fluid Mech. 49 (1971) 625; Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980)
/// 509; Cooker, Weidman & Bale, Reflection of a high-amplitude solitary wave at a vertical wall, J. Fluid Mech. 342
/// (1997) 141.
#pragma once

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class WallRunup {
 public:
  /// @param amplitude  of the incident wave [m], amplitude/depth in [0.05, 0.6];  @param depth  undisturbed [m]
  /// @param markers    even, at least 128;  @param tolerance  of a time step, in units of the depth
  /// Throws std::invalid_argument, and Divergence if the collision is not resolved.
  explicit WallRunup(double amplitude, double depth = 1, std::size_t markers = 384, double tolerance = 1e-11);

  [[nodiscard]] double runup() const { return runup_; }               ///< R [m]
  [[nodiscard]] double wave_amplitude() const { return amplitude_; }  ///< a [m]
  /// Time from the start, when the crests are separation() from the wall, to the largest run-up, times sqrt(g/depth).
  [[nodiscard]] double runup_time() const { return time_; }
  [[nodiscard]] double separation() const { return separation_; }  ///< [m]

  /// Series in a/depth [m], with amplitude and depth [m].
  static double su_mirie(double amplitude, double depth = 1);
  static double byatt_smith(double amplitude, double depth = 1);

  static Provenance provenance();
  /// Difference of R from a second computation with two thirds of the markers and ten times the tolerance, relative to
  /// R. Takes as long as that computation.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double amplitude_;
  double depth_;
  std::size_t markers_;
  double tolerance_;
  double separation_;
  double runup_ = 0;
  double time_ = 0;
  double volume_change_ = 0;
  double energy_change_ = 0;
  double asymmetry_ = 0;
};

}  // namespace seiche::exact
