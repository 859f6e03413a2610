// The conservative step of the plan model over a surveyed bottom, far from where the bottom's integral begins.
#include <cmath>
#include <memory>
#include <string>

#include "seiche/divergence.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_plan_far_bottom_test {

using namespace dispersive_shallow_water_2d;

constexpr double begin = 400;  // of the water
constexpr double length = 10;
constexpr double width = 6;
constexpr int steps = 60;

/// Between 0.5 and 1 deep, from x = 0 on, through elevations half a depth apart.
std::shared_ptr<const PlanBottom> surveyed_bottom() {
  return std::make_shared<SplineBottom>(SplineBottom::sampled(
      {.begin = 0, .end = begin + length + 2, .south = -2, .north = width + 2, .spacing = 0.5},
      [](double x, double y) { return -0.75 + 0.2 * std::sin(0.9 * x) * std::cos(0.7 * y) + 0.05 * std::sin(y); }));
}

/// A hump at one end: next to nothing moves at the other for a while.
Flow basin() {
  const Rectangle rectangle{
      .begin = begin,
      .end = begin + length,
      .south = 0,
      .north = width,
      .columns = 20,
      .rows = 12,
      .elevation = [](double x,
                      double y) { return 0.05 * std::exp(-2 * ((x - begin) * (x - begin) + (y - 1) * (y - 1))); },
      .bottom = surveyed_bottom()};
  return Flow(rectangular_lattice(rectangle), {}, {.stepping = mechanics::Stepping::conservative},
              {.solver = linear::SolverMethod::banded});
}

TEST_CASE("conservative steps settle over a surveyed bottom far from where its integral begins", "[conservation]") {
  Check check("dispersive_plan_far_bottom", "Conservative steps far along a surveyed bottom",
              "A hump of 0.05 spreads over a bottom given by a raster, 400 depths from the raster's west side: the "
              "integral of the bottom, which volumes are sums of, has counted to 300 there, while far from the hump "
              "markers move by less than a millionth. The discrete gradient divides by such ways; what it divides must "
              "not have the round-off of the integral, or sweeps never settle.");
  const std::string source = "Frank (1994), chapter 1 and section 4.2; discrete gradients: McLachlan et al. (1999)";
  check.source(source);
  Flow flow = basin();
  const double energy = flow.energy();
  int done = 0;
  Worst drift;
  try {
    for (; done < steps; ++done) {
      flow.advance(0.15);
      drift.add(flow.energy() / energy - 1);
    }
  } catch (const Divergence&) {
    // Told by the number of steps.
  }
  check.that("settles", "The number of steps whose sweeps do not settle is zero.", "steps that did not",
             {static_cast<double>(steps - done)}, Bound{0, "sweeps contract by (omega tau)^2/4 = 0.02"});
  check.that(
      "energy", "Energy is conserved to round-off where the bathymetry reaches far.",
      "largest change over the first value", {drift.value()},
      Roundoff{steps, begin / 0.5,
               "the width of a cell, half a depth, is a difference of places of 400, rounded anew in each step"});
  std::vector<double> changes(flow.model().constraints());
  flow.model().constraint_values(flow.state().q, changes);
  Worst volume;
  for (const double change : changes) volume.add(change);
  check.that("volume", "The volume of every cell is conserved to round-off.", "largest change of a volume [depth^3]",
             {volume.value()},
             Roundoff{24.0 + steps, 0.75 * begin * 0.5,
                      "the volume itself is a sum of four edges half a depth long, each with the integral, 300, at "
                      "three places; steps add what they round"});
}

}  // namespace seiche::verification::dispersive_plan_far_bottom_test
