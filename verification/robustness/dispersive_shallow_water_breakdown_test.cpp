// How the dispersive shallow-water model breaks down: with time, step and place, and the state of before.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "verification/robustness/breakdown.hpp"

namespace seiche::verification::dispersive_shallow_water_breakdown_test {

using namespace dispersive_shallow_water_1d;

/// Runs with steps of at most tau and 0.9 of the longest stable one.
void breaks_down(Check& check, const std::string& run, Flow flow, double tau, double end, const std::string& word,
                 double leftmost, double rightmost) {
  const auto advance = [tau](Flow& f) { f.advance(std::min(tau, 0.9 * f.stable_step())); };
  holds_of_breakdown(check, run, run_until_breakdown(flow, end, advance), word, leftmost, rightmost);
  check.holds(run + ": The longest stable step is still defined.",
              {std::isfinite(flow.stable_step()) && flow.stable_step() > 0 ? 1.0 : 0.0},
              Qualitative{"finite and positive after the failure", "a caller may go on with a shorter step"});
}

Channel beach(double cotangent, double wall, double table_end) {
  return {.bottom = std::make_shared<PiecewiseLinearBottom>(std::vector<double>{wall - 1, -cotangent, 0, table_end},
                                                            std::vector<double>{-1, -1, 0, table_end / cotangent}),
          .right = End::tip};
}

constexpr std::array schemes{std::pair{"one-step", Stepping::one_step},
                             std::pair{"feedback", Stepping::one_step_feedback},
                             std::pair{"conservative", Stepping::conservative}};
const Channel level{.bottom = std::make_shared<LevelBottom>(1.0)};

TEST_CASE("a backwash that a conservative model cannot carry stops with time, step and position", "[robustness]") {
  Check check("dispersive_backwash", "A backwash bore stops the run where it forms",
              "A solitary wave of height 0.05 runs up a slope of 1 in 10 and back. The backwash steepens into a bore, "
              "which a model without dissipation cannot carry: nodes cross or the water is gone.");
  const Channel channel = beach(10, -45, 20);
  const Markers wave = solitary_markers(channel, -40, 0, 0.125, {.amplitude = 0.05, .crest = -20});
  breaks_down(check, "backwash", Flow(channel, wave), 0.03, 80, "marker", -10, 3);
}

TEST_CASE("a wave beyond the table of the bottom stops with time, step and position", "[robustness]") {
  Check check("dispersive_short_bottom", "A wave runs off the table of the bottom",
              "The table of the bottom ends 0.3 above the still-water level's shore, below the run-up. The tip leaves "
              "it with every scheme; the state remains the last valid one.");
  const Channel channel = beach(2, -35, 0.3);
  const Markers wave = solitary_markers(channel, -30, 0, 0.25, {.amplitude = 0.3, .crest = -10});
  for (const auto& [name, stepping] : schemes) {
    breaks_down(check, name, Flow(channel, wave, {.stepping = stepping}), 0.05, 40, "outside the bottom profile", 0.3,
                0.6);
  }
}

TEST_CASE("a pressure that is not a number stops with time, step and position", "[robustness]") {
  Check check("dispersive_bad_pressure", "A pressure that is not a number",
              "A surface pressure that becomes NaN for x > 7 after some steps.");
  Forcing forcing;
  forcing.surface_pressure = [](double x, double t) {
    return t > 0.3 && x > 7 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  };
  const Markers still = still_markers(level, equal_labels(level, 0, 10, 40));
  for (const auto& [name, stepping] : schemes) {
    breaks_down(check, name, Flow(level, still, {.stepping = stepping}, forcing), 0.1, 1, "not finite", 0, 10);
  }
}

TEST_CASE("steps far beyond the stability limit stop", "[robustness]") {
  Check check("dispersive_long_steps", "Steps beyond the stability limit",
              "The limit is $2\\sqrt{\\alpha H/g}$, 1.155 on still water of depth 1. Steps of 20 sqrt(h/g) make the "
              "nodes of a wave cross or the iteration fail.");
  const Flow still(level, still_markers(level, equal_labels(level, 0, 10, 40)));
  check.holds("The limit on still water is 2 (1/3)^(1/2).", {still.stable_step()},
              Roundoff{3, 2, "three rounded operations", 2 / std::sqrt(3.0)});
  Channel rough = level;
  rough.friction = {FrictionLaw::quadratic, 0.01};
  for (const auto& [name, stepping] : schemes) {
    Flow flow(rough, solitary_markers(level, 0, 60, 0.25, {.amplitude = 0.5, .crest = 30}), {.stepping = stepping});
    bool stopped = false;
    for (int step = 0; step < 100 && !stopped; ++step) {
      const mechanics::State last = flow.state();
      const double lost = flow.lost().friction;
      try {
        flow.advance(20);
      } catch (const Divergence&) {
        stopped = flow.state().q == last.q && flow.state().u == last.u && flow.lost().friction == lost;
      }
    }
    check.holds(
        std::string("too-long-") + name +
            ": The state after the breakdown of a wave in far too long steps is the state before the step.",
        {stopped ? 1.0 : 0.0},
        Qualitative{"seiche::Divergence within 100 steps, coordinates, rates and the loss by friction as before",
                    "as for any failure"});
  }
}

}  // namespace seiche::verification::dispersive_shallow_water_breakdown_test
