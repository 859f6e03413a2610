#include "validation/run_up/run_down.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/peak.hpp"

namespace seiche::validation {

namespace {

bool in_the_water(const dispersive::Flow& flow, double place) {
  const auto finite = [](std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  };
  const double cell = flow.x()[1] - flow.x()[0];
  return finite(flow.x()) && finite(flow.y()) && finite(flow.p()) && finite(flow.r()) &&
         place >= flow.x().front() - cell && place <= largest(flow.x()) + cell;
}

}  // namespace

RunDown run_down(const SolitaryClimb& climb) {
  constexpr double fallen = 0.9;
  const double end = climb.time_to(-climb.cot_slope) + 5 * climb.cot_slope + 20;  // up, down and away
  RunDown fate;
  dispersive::Flow flow = climb.start();
  const double energy = flow.energy();
  Peak edge;
  Smallest lowest;
  Largest later;  // from the lowest on
  try {
    while (flow.time() < end) {
      flow.advance(climb.step(flow));
      const double shoreline = flow.y().back();
      if (!fate.fell) {
        edge.add(flow.time(), shoreline);
        fate.fell = edge.value() > climb.amplitude && shoreline < fallen * edge.value();
      } else if (lowest.count() == 0 || shoreline < lowest.value()) {
        lowest.add(shoreline);
        later = {};
      }
      if (lowest.count() > 0) later.add(shoreline);
    }
  } catch (const Divergence& failure) {
    fate.failure = failure.what();
    fate.failure_time = failure.time();
    fate.failure_place = failure.place();
    fate.sound = std::isfinite(failure.time()) && in_the_water(flow, failure.place());
  }
  if (fate.fell) fate.runup = edge.value();
  fate.runup_time = edge.time();
  fate.lowest = lowest.value();
  fate.later = later.value();
  fate.energy = flow.energy() / energy;
  return fate;
}

}  // namespace seiche::validation
