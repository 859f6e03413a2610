/// Simple wave that runs to the right into still water, until it breaks.
///
/// u = 2 (c - c0) and each depth keeps its speed 3c - 2c0: with s the place where the characteristic through (x, t)
/// started, x = s + (3 c(s) - 2 c0) t. Solved for s by Newton's method within a bracket.
/// It breaks at t = -1/(3 min c'(s)), the first crossing of characteristics.
///
/// When not to use it: at or after the breaking time (refused), or when the wave meets a wall.
///
/// References: Stoker, Water Waves (1957), 10.3; Whitham, Linear and Nonlinear Waves (1974), 13.10.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

class SimpleWave {
 public:
  /// Initial depth h(x) [m] and its slope dh/dx [1] on [start, end]; outside the water is still_depth deep.
  struct Profile {
    std::function<double(double)> depth;
    std::function<double(double)> slope;
    double start = 0;
    double end = 0;
  };

  /// Throws std::invalid_argument when the depth is not positive on [start, end] or does not join the still water.
  SimpleWave(double gravity, double still_depth, Profile profile);

  /// Hump h = still_depth + amplitude cos^6(pi (x - centre)/length), |x - centre| < length/2.
  static SimpleWave hump(double gravity, double still_depth, double amplitude, double centre, double length);

  /// State at (x, t), 0 <= t < breaking_time(). Throws std::invalid_argument outside.
  [[nodiscard]] shallow_water::State at(double x, double t) const;
  /// Ends of the wave [m].
  [[nodiscard]] std::vector<double> breakpoints(double t) const {
    return {profile_.start + still_celerity_ * t, profile_.end + still_celerity_ * t};
  }

  /// When the wave first becomes vertical [s]; infinity for a wave that only falls.
  [[nodiscard]] double breaking_time() const { return breaking_time_; }
  /// Where it does [m]; meaningless when it never breaks.
  [[nodiscard]] double breaking_place() const { return breaking_place_; }

  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_;
  double still_celerity_ = 0;
  Profile profile_;
  double breaking_time_, breaking_place_;
};

}  // namespace seiche::exact
