#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace seiche {

/// A configuration that cannot be: a place beyond a bottom or a curve, cells that tangle, water that is gone.
class Infeasible : public std::runtime_error {
 public:
  /// @param what   "width of cell 12 is -0.1". @param place  coordinate
  Infeasible(const std::string& what, double place) : std::runtime_error(what), place_(place) {}
  template <class... Arguments>
  Infeasible(double place, fmt::format_string<Arguments...> what, Arguments&&... arguments)
      : Infeasible(fmt::format(what, std::forward<Arguments>(arguments)...), place) {}
  [[nodiscard]] double place() const { return place_; }

 private:
  double place_;
};

/// Thrown by a computation that breaks down: not by bad input, which is std::invalid_argument.
///
/// Carries when and where, so that a report can say more than "NaN".
class Divergence : public std::runtime_error {
 public:
  /// @param quantity  the first quantity that went bad, with the reason ("width of particle 12 is negative")
  /// @param time      physical time at the start of the step that failed
  /// @param step      number of steps completed before it
  /// @param place     coordinate at which it happened
  Divergence(const std::string& quantity, double time, long step, double place)
      : std::runtime_error(fmt::format("{} at x = {:.6g}, t = {:.6g}, after {} steps", quantity, place, time, step)),
        time_(time),
        step_(step),
        place_(place) {}

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] double place() const { return place_; }

 private:
  double time_;
  long step_;
  double place_;
};

}  // namespace seiche
