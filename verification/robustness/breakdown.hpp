/// Runs that must break down, and what their end must say: why, when, where, with the state of before.
#pragma once

#include <limits>
#include <string>
#include <type_traits>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/state.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// A run until it breaks down, and whether the failing step left the state as it was.
struct Breakdown {
  std::string message;
  double time = std::numeric_limits<double>::quiet_NaN();
  double place = std::numeric_limits<double>::quiet_NaN();
  bool says_when = false, kept = false;
};

/// @param advance  advance(flow) takes one step; or the length of all steps
template <class Flow, class Advance>
Breakdown run_until_breakdown(Flow& flow, double end, const Advance& advance) {
  if constexpr (std::is_arithmetic_v<Advance>) {
    return run_until_breakdown(flow, end, [&](Flow& f) { f.advance(advance); });
  } else {
    Breakdown result;
    while (flow.time() < end) {
      const mechanics::State before = flow.state();
      try {
        advance(flow);
      } catch (const Divergence& failure) {
        const mechanics::State& after = flow.state();
        result.message = failure.what();
        result.time = failure.time();
        result.place = failure.place();
        result.says_when = failure.time() == before.time && failure.step() == before.steps;
        result.kept = after.q == before.q && after.u == before.u && after.time == before.time &&
                      after.steps == before.steps && after.multipliers == before.multipliers;
        break;
      }
    }
    return result;
  }
}

/// The run stops and says why, when and where; the state is that of before the failing step.
/// @param word  in the message;  @param leftmost, rightmost  where the failure is known to begin
inline void holds_of_breakdown(Check& check, const std::string& run, const Breakdown& breakdown,
                               const std::string& word, double leftmost, double rightmost) {
  INFO(run << ": " << breakdown.message);
  const auto holds = [&](const std::string& what, bool value, const std::string& detector, const std::string& reason) {
    check.holds(run + ": " + what, {value ? 1.0 : 0.0}, evidence::Qualitative{detector, reason});
  };
  holds("The run stops and states the cause.", breakdown.message.find(word) != std::string::npos,
        "seiche::Divergence whose message contains \"" + word + "\"", "no result may follow from a broken state");
  holds("The message states time and step of the last valid state.", breakdown.says_when,
        "time and steps of the state before the failing step", "the message must lead to the cause");
  holds("The message states the position of the failure.", breakdown.place >= leftmost && breakdown.place <= rightmost,
        "position where the failure is known to begin", "the message must lead to the cause");
  holds("The state before the failing step is preserved.", breakdown.kept,
        "equal coordinates, rates, multipliers, time and number of steps", "a caller may go on with a shorter step");
}

}  // namespace seiche::verification
