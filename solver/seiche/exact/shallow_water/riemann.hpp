/// Riemann problem of the shallow-water equations on a flat bed, and what is made of it: bores, their reflection from a
/// wall and their collision.
///
/// Two uniform states meet at a jump at t = 0:
///
///     fL(h*) + fR(h*) + uR - uL = 0,   u* = (uL + uR)/2 + (fR - fL)/2
///
/// with f_K the velocity change across the K-wave (shallow_water/relations.hpp). Each wave is a simple-wave fan or a
/// hydraulic jump. One side may be dry (the fan then ends in a dry front) and the bed may dry in the middle. Evaluated
/// to round-off at any point and instant.
///
/// Jump conditions: h1 (u1 - a) = h0 (u0 - a),  h1 (u1 - a)(u1 - u0) = (g/2)(h0^2 - h1^2), with h1 > h0 behind.
///
/// When not to use it: uneven bed, friction, undular bores (h1/h0 below about 1.3 in reality); once a wave has met
/// another, but for the reflection and the collision below.
///
/// References: Toro, Shock-capturing methods for free-surface shallow flows (2001), ch. 5-6; Ritter, Die Fortpflanzung
/// der Wasserwellen, Zeitschrift des VDI 36 (1892); Stoker, Water Waves (1957), 10.6-10.8; Bogomolov, Zakharov and
/// Zerkal, Modelling of shallow-water waves by the particle method, formula (11) and section 5.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

class Riemann {
 public:
  using State = shallow_water::State;

  enum class Kind { none, fan, jump, dry };

  /// One of the two waves: its slowest and fastest characteristic [m/s], equal for a jump.
  struct Wave {
    Kind kind = Kind::none;
    double slowest = 0;
    double fastest = 0;
  };

  /// @param gravity      [m/s^2], positive
  /// @param left, right  depth [m] >= 0, at least one positive; velocity [m/s]. The velocity of a dry side is ignored;
  ///                     positive depths below 1e-100, or eps^2 of the other or of velocity^2/gravity, are refused.
  /// @param jump         position of the discontinuity at t = 0 [m]
  /// Throws std::invalid_argument.
  Riemann(double gravity, State left, State right, double jump = 0);

  /// State at (x, t), t >= 0; velocity 0 where the bed is dry. Throws std::invalid_argument for t < 0.
  [[nodiscard]] State at(double x, double t) const;
  [[nodiscard]] double depth(double x, double t) const { return at(x, t).depth; }
  [[nodiscard]] double velocity(double x, double t) const { return at(x, t).velocity; }

  /// State on the ray (x - jump)/t = speed [m/s].
  [[nodiscard]] State sample(double speed) const;

  /// State between the two waves; depth 0 when a side is dry or the middle dries.
  [[nodiscard]] State star() const { return star_; }
  [[nodiscard]] Wave left_wave() const { return left_wave_; }
  [[nodiscard]] Wave right_wave() const { return right_wave_; }
  [[nodiscard]] State left() const { return left_; }
  [[nodiscard]] State right() const { return right_; }
  [[nodiscard]] double gravity() const { return gravity_; }
  [[nodiscard]] double jump() const { return jump_; }

  /// Positions of jumps and corners at time t, increasing [m].
  [[nodiscard]] std::vector<double> breakpoints(double t) const;

  // Closed formulas of some ten roundings each; the depth between the waves is iterated to its last digit.
  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_;
  State left_;
  State right_;
  double jump_;
  State star_;
  Wave left_wave_;
  Wave right_wave_;
};

/// Bore that runs to the right into water of depth `ahead`.
class Bore {
 public:
  /// @param ahead, behind    depths h0, h1 [m], 0 < ahead < behind: a fall of depth would gain energy and is refused
  /// @param ahead_velocity   u0 [m/s]
  /// @param start            position at t = 0 [m]
  /// Throws std::invalid_argument.
  Bore(double gravity, double ahead, double behind, double ahead_velocity = 0, double start = 0);

  /// Bore with a given particle velocity u1 > 0 behind it, into water at rest: finds h0 from h1 and u1.
  static Bore from_velocity(double gravity, double behind, double behind_velocity, double start = 0);

  [[nodiscard]] shallow_water::State at(double x, double t) const;
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return {position(t)}; }
  [[nodiscard]] double position(double t) const { return start_ + speed() * t; }

  [[nodiscard]] shallow_water::State ahead() const { return ahead_; }
  [[nodiscard]] shallow_water::State behind() const { return behind_; }
  [[nodiscard]] double gravity() const { return gravity_; }
  /// Speed of the bore a = u0 + sqrt(g h1 (h1 + h0)/(2 h0)) [m/s].
  [[nodiscard]] double speed() const { return ahead_.velocity + mass_flux() / ahead_.depth; }
  /// Particle velocity behind the bore u1 = u0 + (a - u0)(1 - h0/h1) [m/s].
  [[nodiscard]] double behind_velocity() const { return behind_.velocity; }
  /// Mass swept per unit time sqrt(g h0 h1 (h0 + h1)/2) [m^2/s], the same for every observer.
  [[nodiscard]] double mass_flux() const { return flux_; }
  /// Energy lost per unit time, width and density, M g (h1 - h0)^3/(4 h0 h1) [m^4/s^3].
  [[nodiscard]] double energy_loss_rate() const {
    return flux_ * gravity_ * std::pow(behind_.depth - ahead_.depth, 3) / (4 * ahead_.depth * behind_.depth);
  }

 private:
  double gravity_;
  shallow_water::State ahead_;
  double start_, flux_;
  shallow_water::State behind_;
};

/// Two bores run towards each other through still water, meet, and pass: before the meeting two jumps, after it the
/// Riemann problem of the two states behind them.
class CollidingBores {
 public:
  /// @param left, right            depths behind the two bores [m], both above `middle`
  /// @param middle                 depth of the still water between [m]
  /// @param left_start, right_start  positions at t = 0 [m], left_start < right_start
  /// Throws std::invalid_argument.
  CollidingBores(double gravity, double left, double middle, double right, double left_start, double right_start);

  [[nodiscard]] shallow_water::State at(double x, double t) const;
  [[nodiscard]] std::vector<double> breakpoints(double t) const;

  [[nodiscard]] double collision_time() const { return time_; }
  [[nodiscard]] double collision_place() const { return after_.jump(); }
  /// The bore from the left, and the Riemann problem after the collision, its time counted from there.
  [[nodiscard]] const Bore& left_bore() const { return left_; }
  [[nodiscard]] const Riemann& after() const { return after_; }
  /// State between the two jumps after the collision.
  [[nodiscard]] shallow_water::State star() const { return after_.star(); }
  /// States behind the left (u > 0) and right (u < 0) bore.
  [[nodiscard]] shallow_water::State left() const { return after_.left(); }
  [[nodiscard]] shallow_water::State right() const { return after_.right(); }

 private:
  Bore left_;
  Bore right_;  // mirrored: runs to the right in -x
  double time_;
  Riemann after_;
};

/// A bore meets a vertical wall and runs back: water at rest, deeper than behind the incident bore, between it and the
/// wall,
///
///     u1 = (h2 - h1) sqrt(g (h2 + h1)/(2 h1 h2)),   a- = -u1 h1/(h2 - h1)
///
/// which is the collision with its mirror image.
class BoreReflection {
 public:
  /// @param incident  bore that runs to the right;  @param wall  position [m], to the right of the bore at t = 0.
  /// Water ahead of the bore must be at rest. Throws std::invalid_argument.
  BoreReflection(const Bore& incident, double wall);

  /// From depth h1 and velocity u1 behind the incident bore; h0 follows.
  static BoreReflection from_velocity(double gravity, double behind, double behind_velocity, double start,
                                      double wall) {
    return {Bore::from_velocity(gravity, behind, behind_velocity, start), wall};
  }

  /// State at x <= wall, t >= 0. Throws std::invalid_argument beyond the wall.
  [[nodiscard]] shallow_water::State at(double x, double t) const;
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return {position(t)}; }

  [[nodiscard]] const Bore& incident() const { return with_image_.left_bore(); }
  [[nodiscard]] double wall() const { return wall_; }
  /// When the bore meets the wall [s].
  [[nodiscard]] double reflection_time() const { return with_image_.collision_time(); }
  /// Depth between wall and reflected jump h2 [m].
  [[nodiscard]] double reflected_depth() const { return with_image_.star().depth; }
  /// Velocity of the reflected jump a- < 0 [m/s].
  [[nodiscard]] double reflected_speed() const { return with_image_.after().left_wave().fastest; }
  /// Position of the incident, then of the reflected jump [m].
  [[nodiscard]] double position(double t) const;

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double wall_;
  CollidingBores with_image_;
};

/// Mass and momentum across a hydraulic jump of velocity `speed` [m/s], seen by an observer who moves with it.
/// @param name     which jump, for the identities' names
/// @param largest  velocity [m/s] that those on both sides were computed from, whose rounding they carry
SelfTest jump_identities(const std::string& name, double gravity, shallow_water::State left, shallow_water::State right,
                         double speed, double largest = 0);

}  // namespace seiche::exact
