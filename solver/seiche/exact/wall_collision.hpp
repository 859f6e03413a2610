/// Two equal solitary waves of the Euler equations that collide head-on: one wave and its image in a vertical wall.
///
/// They move in a periodic channel, so far apart at the start that less than 1e-13 of each is left under the other, by
/// Cauchy's integral (overturning/evolution.hpp). The wall is at the label in the middle; the other end of the channel
/// is the image of a second wall, which both waves leave.
#pragma once

#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/solitary_wave.hpp"

namespace seiche::exact {

class WallCollision {
 public:
  /// Moves the waves until the water at the wall falls.
  ///
  /// @param amplitude  of the incident wave [m], amplitude/depth in [0.05, 0.6];  @param depth  undisturbed [m]
  /// @param markers    even, at least 128;  @param tolerance  of a time step, in units of the depth
  /// Throws std::invalid_argument, and Divergence if the collision is not resolved.
  WallCollision(double amplitude, double depth, std::size_t markers, double tolerance);

  /// amplitude/depth of a wave that the method resolves. Throws std::invalid_argument.
  static double checked_ratio(double amplitude, double depth);

  /// In units of period/2 pi, the wall at x = pi.
  [[nodiscard]] const overturning::Evolution& motion() const { return motion_; }
  /// The moment at which the marker at the wall is highest.
  [[nodiscard]] const overturning::Moment& highest() const { return highest_; }
  /// Moves the waves on until the marker at the wall is lower than `level` [m].
  /// Throws Divergence if the water is not resolved so long.
  void advance_until_below(double level);

  [[nodiscard]] std::size_t wall() const { return wall_; }         ///< its marker
  [[nodiscard]] double wavenumber() const { return k_; }           ///< 2 pi/period, in units of 1/depth
  [[nodiscard]] double length() const { return depth_ / k_; }      ///< unit of the motion [m]
  [[nodiscard]] double separation() const { return separation_; }  ///< of the crests from the wall at the start [m]
  /// When the wave would be at the wall if it went on alone, in units of the motion.
  [[nodiscard]] double crossing() const { return crossing_; }

 private:
  /// @param wave  in units of the depth
  WallCollision(const SolitaryWave& wave, double depth, std::size_t markers, double tolerance);

  /// Of the marker at the wall.
  [[nodiscard]] double rise(const overturning::Moment& moment) const;
  void require_resolved() const;

  double depth_;
  double separation_;
  double k_;
  double crossing_;
  std::size_t wall_;
  overturning::Evolution motion_;
  overturning::Moment highest_;
};

}  // namespace seiche::exact
