/// Riemann problem of the shallow-water equations on a flat bed: two uniform states meet at a jump at t = 0.
///
///     fL(h*) + fR(h*) + uR - uL = 0,   u* = (uL + uR)/2 + (fR - fL)/2
///
/// with f_K the velocity change across the K-wave (relations.hpp). Each wave is a simple-wave fan or a hydraulic jump.
/// One side may be dry (the fan then ends in a dry front) and the bed may dry in the middle.
/// Evaluated to round-off at any point and instant.
///
/// When not to use it: uneven bed, friction, or once a wave has met a wall (BoreReflection) or another wave
/// (CollidingBores).
///
/// References: Toro, Shock-capturing methods for free-surface shallow flows (2001), ch. 5-6; Stoker, Water Waves
/// (1957).
#pragma once

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

  /// Discharge h u at the place of the initial jump, constant for t > 0 [m^2/s].
  [[nodiscard]] double discharge_at_jump() const;

  /// Positions of jumps and corners at time t, increasing [m].
  [[nodiscard]] std::vector<double> breakpoints(double t) const;

  /// See ReferenceSolution.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;
  static Provenance provenance();

 private:
  double gravity_;
  State left_;
  State right_;
  double jump_;
  State star_;
  Wave left_wave_;
  Wave right_wave_;
};

}  // namespace seiche::exact
