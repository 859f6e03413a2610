/// Run-up of a solitary wave on a vertical wall: fully nonlinear potential flow.
///
/// The wave and its mirror image in the wall collide head-on: two solitary waves of the full Euler equations in a
/// periodic channel, so far apart at the start that less than 1e-13 of each is left under the other, moved by Cauchy's
/// integral (overturning/evolution.hpp). The wall is at the label in the middle; the other end of the channel is the
/// image of a second wall, which both waves leave. Run-up R is the highest elevation of the marker at the wall above
/// the undisturbed level. In units of the depth, for small a:
///
///     R = 2a + a^2/2 + 3a^3/4 + O(a^4)   (Su & Mirie),   R = 2a + a^2/2 + O(a^3)   (Byatt-Smith).
///
/// When not to use it: amplitudes above 0.6 depths, where a thin jet rises along the wall; breaking waves.
///
/// References: Byatt-Smith, An integral equation for unsteady surface waves and a comment on the Boussinesq equation,
/// J. Fluid Mech. 49 (1971) 625; Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980)
/// 509; Cooker, Weidman & Bale, Reflection of a high-amplitude solitary wave at a vertical wall, J. Fluid Mech. 342
/// (1997) 141.
///
/// Load of a solitary wave on a vertical wall: pressure at the still-water level and at the foot, and force, in time.
///
/// The wave and its image in the wall move as in wall_runup.hpp; the pressure along the wall is that of Bernoulli's
/// equation (overturning/wall_column.hpp). Pressures are p/(rho g) [m], 0 in the air, depth at the foot at rest; the
/// force per unit width is int p dy/(rho g) [m^2], depth^2/2 at rest.
///
/// In units of the depth, for small a: water at the wall rises to R = 2a + a^2/2 + 3a^3/4 (Su & Mirie), where it is
/// accelerated downwards with 3a^2 at the surface and with 3a^2 (1 + y) below, that of 2a sech^2(sqrt(3a)t/2). So
///
///     p(0) = R (1 - 3a^2) = 2a + a^2/2 - 21a^3/4 + O(a^4)
///     p(-1) = 1 + R - 3a^2/2 = 1 + 2a - a^2 + O(a^3)
///     F = (1 + R)^2/2 - a^2 = 1/2 + 2a + 3a^2/2 + O(a^3).
///
/// When not to use it: amplitudes above 0.6 depths, where a thin jet rises along the wall; above 0.55 depths also while
/// that jet falls, which 384 markers resolve to some 1e-6 only; breaking waves.
///
/// References: Su & Mirie, On head-on collisions between two solitary waves, J. Fluid Mech. 98 (1980) 509; Fenton &
/// Rienecker, A Fourier method for solving nonlinear water-wave problems: application to solitary-wave interactions, J.
/// Fluid Mech. 118 (1982) 411; Cooker, Weidman & Bale, Reflection of a high-amplitude solitary wave at a vertical wall,
/// J. Fluid Mech. 342 (1997) 141.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/wall_column.hpp"
#include "seiche/exact/reference_solution.hpp"
#include "seiche/exact/solitary_wave.hpp"

namespace seiche::exact {

class WallRunup {
 public:
  /// @param amplitude  of the incident wave [m], amplitude/depth in [0.05, 0.6];  @param depth  undisturbed [m]
  /// @param markers    even, at least 128;  @param tolerance  of a time step, in units of the depth
  /// Throws std::invalid_argument, and Divergence if the collision is not resolved.
  explicit WallRunup(double amplitude, double depth = 1, std::size_t markers = 384, double tolerance = 1e-11)
      : WallRunup(amplitude, depth, markers, tolerance, 1) {}

  [[nodiscard]] double runup() const { return overturning::view(highest_.state).y[wall_] * length(); }  ///< R [m]
  [[nodiscard]] double wave_amplitude() const { return amplitude_; }                                    ///< a [m]
  [[nodiscard]] double depth() const { return depth_; }                                                 ///< [m]
  /// Time from the start, when the crests are separation() from the wall, to the largest run-up, times sqrt(g/depth).
  [[nodiscard]] double runup_time() const { return highest_.time / std::sqrt(k_); }
  [[nodiscard]] double separation() const { return separation_; }  ///< [m]

  /// Series in a/depth [m], with amplitude and depth [m].
  static double su_mirie(double amplitude, double depth = 1);
  static double byatt_smith(double amplitude, double depth = 1);

  /// Difference of R from a second computation with two thirds of the markers and ten times the tolerance, relative to
  /// R. Takes as long as that computation.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;
  /// What a self-test will say of a wave of amplitude/depth `ratio`, without its defects, which are NaN.
  static SelfTest identities(double ratio, std::size_t markers = 384, double tolerance = 1e-11);

 protected:
  /// @param fall  the motion is followed until the water at the wall is lower than this part of its run-up
  WallRunup(double amplitude, double depth, std::size_t markers, double tolerance, double fall);

  [[nodiscard]] double length() const { return depth_ / k_; }  ///< unit of the motion [m]
  /// The second computation.
  template <class Solution>
  [[nodiscard]] Solution coarser() const {
    return Solution(amplitude_, depth_, std::max<std::size_t>(128, markers_ / 3 * 2), 10 * tolerance_);
  }
  /// The identity of a square that the errors of the time steps limit.
  [[nodiscard]] Identity within_steps(const std::string& name, double defect) const;

  double amplitude_, depth_;
  std::size_t markers_, wall_;  ///< and the marker at the wall
  double k_ = 0;                ///< 2 pi/period, in units of 1/depth
  double separation_ = 0;       ///< of the crests from the wall at the start [m]
  double crossing_ = 0;         ///< when the wave would be at the wall if it went on alone, in units of the motion
  /// In units of period/2 pi, the wall at x = pi.
  std::shared_ptr<const overturning::Evolution> motion_;
  overturning::Moment highest_;  ///< when the marker at the wall is highest

 private:
  double tolerance_;
};

/// The load of the same wave, followed until the water at the wall has fallen to half of its height, long after the
/// largest loads.
class WallLoad : public WallRunup {
 public:
  /// As those of WallRunup.
  explicit WallLoad(double amplitude, double depth = 1, std::size_t markers = 384, double tolerance = 1e-11);

  /// At one time.
  struct Load {
    double time = 0;    ///< from the start, when the crests are separation() from the wall, times sqrt(g/depth)
    double level = 0;   ///< of the water at the wall [m]
    double still = 0;   ///< p/(rho g) at y = 0 [m]
    double bottom = 0;  ///< p/(rho g) at y = -depth [m]
    double force = 0;   ///< int p dy/(rho g) [m^2]
  };
  /// Throws std::out_of_range outside the motion.
  [[nodiscard]] Load at(double time) const;
  /// Of every time step since the wave was half-way to the wall.
  [[nodiscard]] const std::vector<Load>& history() const { return history_; }

  struct Peak {
    double value = 0;
    double time = 0;
  };
  [[nodiscard]] Peak largest_still() const { return still_; }
  [[nodiscard]] Peak largest_bottom() const { return bottom_; }
  [[nodiscard]] Peak largest_force() const { return force_; }

  /// Series above for the largest pressure at the undisturbed level, of third order [m].
  static double still_series(double amplitude, double depth = 1);

  /// Largest difference of the three largest values from a second computation with two thirds of the markers and ten
  /// times the tolerance, relative to each. Takes as long as that computation.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] Load load(const overturning::Moment& moment, overturning::SurfaceVelocity& equation) const;
  [[nodiscard]] Peak largest(double Load::*member) const;

  std::vector<Load> history_;
  Peak still_, bottom_, force_;
};

}  // namespace seiche::exact
