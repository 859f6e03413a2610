// The conservative step of the 2DH model over surveyed bottoms: far from where the bottom's integral begins, and
// around an island with its shoreline.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/island_flow.hpp"
#include "verification/check.hpp"

namespace seiche::verification::surveyed_bottom_2dh_test {

using namespace dispersive_shallow_water_2d;

/// A run until a time, or until a step does not settle.
struct Course {
  Worst drift;          ///< of the energy, over its first value
  std::string stopped;  ///< what the step says that does not settle
};

Course follow(
    Flow& flow, double end, double tau, const std::function<void()>& after = [] {}) {
  Course course;
  const double energy = flow.energy();
  try {
    march(flow, end, tau, [&] {
      course.drift.add(flow.energy() / energy - 1, flow.time());
      after();
    });
  } catch (const Divergence& divergence) {
    course.stopped = divergence.what();
  }
  return course;
}

constexpr double begin = 400;  // of the water
constexpr double length = 10, width = 6;
constexpr int steps = 60;

/// A hump at one end, next to nothing moves at the other for a while; between 0.5 and 1 deep, the bottom through
/// elevations half a depth apart from x = 0 on.
Flow basin() {
  return Flow(
      rectangular_lattice(
          {.begin = begin,
           .end = begin + length,
           .north = width,
           .columns = 20,
           .rows = 12,
           .elevation = [](double x,
                           double y) { return 0.05 * std::exp(-2 * (std::pow(x - begin, 2) + std::pow(y - 1, 2))); },
           .bottom = std::make_shared<SplineBottom>(SplineBottom::sampled(
               {.begin = 0, .end = begin + length + 2, .south = -2, .north = width + 2, .spacing = 0.5},
               [](double x, double y) {
                 return -0.75 + 0.2 * std::sin(0.9 * x) * std::cos(0.7 * y) + 0.05 * std::sin(y);
               }))}),
      {}, {.stepping = mechanics::Stepping::conservative}, {.solver = linear::SolverMethod::banded});
}

TEST_CASE("conservative steps converge over a surveyed bottom far from the origin of its integral", "[conservation]") {
  Check check("dispersive_2dh_far_bottom", "Conservative steps far along a surveyed bottom",
              "A hump of 0.05 spreads over a bottom given by a raster, 400 h from the raster's west side: the integral "
              "of the bottom, of which volumes are sums, has grown to 300 there, while far from the hump nodes move by "
              "less than a millionth. The discrete gradient divides by such displacements; its numerator must not have "
              "the round-off of the integral, or sweeps do not converge.",
              "Frank (1994), chapter 1 and section 4.2; discrete gradients: McLachlan et al. (1999)");
  Flow flow = basin();
  const Course course = follow(flow, steps * 0.15, 0.15);
  check.that("settles", "The number of steps whose sweeps do not converge is zero.", "steps that did not",
             {.value = static_cast<double>(steps - flow.steps()), .where = course.stopped},
             Bound{0, "sweeps contract by (omega tau)^2/4 = 0.02"});
  check.that(
      "energy", "Energy is conserved to round-off where the bathymetry reaches far.",
      "largest change over the first value", {course.drift.value()},
      Roundoff{steps, begin / 0.5,
               "the width of a cell, half a depth, is a difference of positions of 400, rounded anew in each step"});
  std::vector<double> changes(flow.model().constraints());
  flow.model().constraint_values(flow.state().q, changes);
  check.that("volume", "The volume of every cell is conserved to round-off.", "largest change of a volume [depth^3]",
             {worst(changes)},
             Roundoff{24.0 + steps, 0.75 * begin * 0.5,
                      "the volume itself is a sum of four edges of length h/2, each with the integral, 300, at three "
                      "positions; roundings of steps add up"});
}

TEST_CASE("conservative steps conserve the energy of a wave that runs up an island", "[conservation][full]") {
  Check check("conical_island_energy", "A wave climbs an island: conservative steps",
              "Case A of the conical island without friction, columns 1 m apart: the shoreline slides on the bottom, "
              "cells next to it are as thin as the water is there, and the bottom is a spline through a raster. Until "
              "a second after the crest would be at the middle of the island, when the water has been highest in front "
              "of it.",
              "Frank (1994), chapter 1 and section 4.2");
  const validation::ConicalIsland island(
      {.height = 0.045, .spacing = 1, .scheme = {.stepping = mechanics::Stepping::conservative}, .drag = {}});
  Flow flow = island.flow();
  const double end = island.passage() + 1;
  Largest highest;
  const Course course = follow(flow, end, island.step(), [&] {
    for (std::size_t i = 0; i <= flow.shape().columns; ++i) highest.add(flow.z()[i]);
  });
  check.at(fmt::format("columns 1 m apart, {} steps", flow.steps()));
  check.that("passes", "The iteration of every step settles until the end time is reached to 1e-9 s.",
             "time that was not reached [s]", {.value = std::max(end - flow.time(), 0.0), .where = course.stopped},
             Bound{1e-9, "rounding of the time; with friction the same wave passes"});
  check.that(
      "climbs",
      "The highest run-up on the island is 2.5 wave heights within 1.25: twice at a wall, 2.8 in the experiment.",
      "largest elevation of the shoreline over the wave's height", {highest.value() / (0.045 * 0.32)},
      Bound{1.25, "the height is doubled at a wall; the experiment's largest is 2.8", 2.5});
  check.that(
      "energy", "Energy of the wave at the island is conserved to round-off.", "largest change over the first value",
      {course.drift.value()},
      Roundoff{static_cast<double>(flow.steps()), 100,
               "positions of 20 m and sides of 0.2 m next to the shore: each step rounds their differences anew"});
}

}  // namespace seiche::verification::surveyed_bottom_2dh_test
