// The conservative step of the plan model around an island, with its shoreline and over a surveyed bottom.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/island_flow.hpp"
#include "verification/check.hpp"

namespace seiche::verification::conical_island_energy_test {

using dispersive_shallow_water_2d::Flow;

constexpr double spacing = 1;  // [m]
constexpr double after = 1;    // [s]: the water has been highest in front of the island

validation::ConicalIsland island() {
  return validation::ConicalIsland(
      {.height = 0.045, .spacing = spacing, .scheme = {.stepping = mechanics::Stepping::conservative}, .drag = {}});
}

TEST_CASE("conservative steps keep the energy of a wave that climbs an island", "[conservation][full]") {
  Check check("conical_island_energy", "A wave climbs an island: conservative steps",
              "Case A of the conical island without friction, columns 1 m apart: the shoreline slides on the bottom, "
              "cells next to it are as thin as the water is there, and the bottom is a spline through a raster. Until "
              "a second after the crest would be at the middle of the island.");
  const std::string source = "Frank (1994), chapter 1 and section 4.2";
  const validation::ConicalIsland set_up = island();
  Flow flow = set_up.flow();
  const double energy = flow.energy();
  const double end = set_up.passage() + after;
  Worst drift;
  Largest highest;
  std::string stopped;
  try {
    while (flow.time() < end) {
      flow.advance(set_up.step());
      drift.add(flow.energy() / energy - 1, flow.time());
      for (std::size_t i = 0; i <= flow.shape().columns; ++i) highest.add(flow.z()[i]);
    }
  } catch (const Divergence& divergence) {
    stopped = divergence.what();
  }
  check.at(fmt::format("columns {:g} m apart, {} steps", spacing, flow.steps()));
  check.from(source).that("passes", "The iteration of every step settles until the end time is reached to 1e-9 s.",
                          "time that was not reached [s]",
                          {.value = std::max(end - flow.time(), 0.0), .where = stopped},
                          Bound{1e-9, "rounding of the time; with friction the same wave passes"});
  check.from(source).that(
      "climbs",
      "The highest run-up on the island is 2.5 wave heights within 1.25: twice at a wall, 2.8 in the experiment.",
      "largest elevation of the shoreline over the wave's height", {highest.value() / (0.045 * 0.32)},
      Bound{1.25, "the height is doubled at a wall; the experiment's largest is 2.8", 2.5});
  check.from(source).that(
      "energy", "Energy of the wave at the island is conserved to round-off.", "largest change over the first value",
      {drift.value()},
      Roundoff{static_cast<double>(flow.steps()), 100,
               "places of 20 m and sides of 0.2 m next to the shore: each step rounds their differences anew"});
}

}  // namespace seiche::verification::conical_island_energy_test
