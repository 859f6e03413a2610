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

#include <memory>
#include <vector>

#include "seiche/exact/overturning/wall_column.hpp"
#include "seiche/exact/reference_solution.hpp"
#include "seiche/exact/wall_collision.hpp"

namespace seiche::exact {

class WallLoad {
 public:
  /// Follows the wave until the water at the wall has fallen to half of its height, long after the largest loads.
  ///
  /// @param amplitude  of the incident wave [m], amplitude/depth in [0.05, 0.6];  @param depth  undisturbed [m]
  /// @param markers    even, at least 128;  @param tolerance  of a time step, in units of the depth
  /// Throws std::invalid_argument, and Divergence if the collision is not resolved.
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

  [[nodiscard]] double wave_amplitude() const { return amplitude_; }            ///< [m]
  [[nodiscard]] double separation() const { return collision_->separation(); }  ///< [m]

  /// Series above for the largest values, with amplitude and depth [m].
  static double still_series(double amplitude, double depth = 1);   ///< third order [m]
  static double bottom_series(double amplitude, double depth = 1);  ///< second order [m]
  static double force_series(double amplitude, double depth = 1);   ///< second order [m^2]

  static Provenance provenance();
  /// Largest difference of the three largest values from a second computation with two thirds of the markers and ten
  /// times the tolerance, relative to each. Takes as long as that computation.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] Load load(const overturning::Moment& moment, overturning::SurfaceVelocity& equation) const;
  [[nodiscard]] Peak largest(double Load::*member) const;

  double amplitude_;
  double depth_;
  std::size_t markers_;
  double tolerance_;
  std::shared_ptr<const WallCollision> collision_;
  std::vector<Load> history_;
  Peak still_, bottom_, force_;
};

}  // namespace seiche::exact
