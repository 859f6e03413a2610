/// Two bores run towards each other through still water, meet, and pass: before the meeting two jumps, after it the
/// Riemann problem of the two states behind them.
///
/// When not to use it: after a reflected jump has met another wave.
///
/// References: Stoker, Water Waves (1957), 10.6-10.8.
#pragma once

#include <vector>

#include "seiche/exact/bore.hpp"
#include "seiche/exact/riemann.hpp"

namespace seiche::exact {

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
  /// State between the two jumps after the collision.
  [[nodiscard]] shallow_water::State star() const { return after_.star(); }
  /// States behind the left (u > 0) and right (u < 0) bore.
  [[nodiscard]] shallow_water::State left() const { return after_.left(); }
  [[nodiscard]] shallow_water::State right() const { return after_.right(); }

  static Provenance provenance();

 private:
  Bore left_;
  Bore right_;  // mirrored: runs to the right in -x
  double time_;
  Riemann after_;
};

}  // namespace seiche::exact
