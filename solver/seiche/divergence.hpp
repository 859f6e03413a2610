#pragma once

#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace seiche {

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
