// The moving shoreline of the 2DH model: rest, conservation, and the slow oscillation of water in a parabolic canal.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::shoreline_2dh_test {

using namespace dispersive_shallow_water_2d;
using plan_lattice::ShoreSide;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 3 and 4";
constexpr double half_width = 10;

/// Canal of depth 1 and bottom -1 + (x/10)^2 between walls y = 0 and y = 2, shores at x = -10 and 10.
std::shared_ptr<const PolynomialBottom> canal() {
  return polynomial_bottom({{-1, 0, 0}, {1 / (half_width * half_width), 2, 0}});
}

/// Its water, moved by `shift` up one side as a whole: the surface is a plane.
Lattice moved_water(std::size_t columns, double shift) {
  const auto bottom = canal();
  Lattice lattice =
      rectangular_lattice({.begin = -half_width, .end = half_width, .north = 2, .columns = columns, .rows = 2});
  lattice.bottom = bottom;
  lattice.sides.west = lattice.sides.east = ShoreSide{};
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const double depth = -bottom->slope(lattice.x[k], 0).elevation;
    lattice.x[k] += shift;
    lattice.z[k] = bottom->slope(lattice.x[k], 0).elevation + (k % (columns + 1) % columns == 0 ? 0 : depth);
  }
  return lattice;
}

/// A bowl -1 + (r/10)^2 as a ring of water between the shore and a wall held at r = 4, a quarter of it.
Lattice ring(double amplitude) {
  constexpr std::size_t columns = 24, rows = 8;
  Lattice lattice{.shape = {columns, rows}, .x = {}, .y = {}, .z = {}};
  lattice.bottom = polynomial_bottom({{-1, 0, 0}, {0.01, 2, 0}, {0.01, 0, 2}});
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i) {
      const double angle = std::numbers::pi / 2 * static_cast<double>(i) / columns;
      const double r = 4 + 6 * static_cast<double>(j) / rows;
      // Rows from the shore inwards.
      const double radius = 14 - r;
      lattice.x.push_back(i == columns ? 0 : radius * std::cos(angle));
      lattice.y.push_back(i == 0 ? 0 : radius * std::sin(angle));
      const double b = lattice.bottom->slope(lattice.x.back(), lattice.y.back()).elevation;
      lattice.z.push_back(j == 0 ? b : amplitude * b * b * std::cos(2 * angle));
    }
  }
  lattice.sides.south = ShoreSide{};
  lattice.sides.north = plan_lattice::HeldSide{};
  return lattice;
}

TEST_CASE("still water with moving shorelines stays at rest", "[conservation]") {
  Check check("shoreline_rest_2dh", "Still water with moving shorelines, in 2DH",
              "Nodes at depth zero stand at the still-water level, and the bottom's part of the potential energy is "
              "taken with the surface's line between them: no force. 200 steps of 0.1. On a circular shore nodes are "
              "at the level only to round-off.",
              source);
  Flow straight(moved_water(20, 0));
  Flow round(ring(0));
  for (int n = 0; n < 200; ++n) {
    straight.advance(0.1);
    round.advance(0.1);
  }
  check.that("straight", "Velocities of still water between straight shores are exactly zero.", "largest velocity",
             {worst(straight.state().u)}, Bound{0, "every force is exactly zero"});
  check.that("round", "Velocities of still water inside a circular shore are zero to round-off.", "largest velocity",
             {worst(round.state().u)}, Roundoff{200, 1, "elevations rounded once, of depth 1, and 200 steps"});
}

TEST_CASE("energy and volumes are conserved with moving shorelines", "[conservation]") {
  Check check("shoreline_conservation_2dh", "Conservation with moving shorelines, in 2DH",
              "The potential energy over moving shores is taken over the areas they flood, with an exact discrete "
              "gradient; shoreline nodes move along the bottom's own discrete tangent. Canal: the water is moved up a "
              "side by a tenth of its half width and let go. Ring: a circular shore, uneven surface.");
  for (const auto& [name, lattice] :
       {std::pair{std::string("Straight shores"), moved_water(20, 1)}, {"A circular shore", ring(0.05)}}) {
    Flow flow(lattice, {}, {.stepping = Stepping::conservative});
    const double energy = flow.energy();
    Worst energy_defect;
    constexpr int steps = 200;
    for (int n = 0; n < steps; ++n) {
      flow.advance(0.1);
      energy_defect.add(flow.energy() / energy - 1);
    }
    std::vector<double> defects(flow.shape().cells());
    flow.model().constraint_values(flow.state().q, defects);
    const auto cells = static_cast<double>(flow.shape().cells());
    check.holds(name + ": the energy.", {energy_defect.value()},
                Roundoff{steps * cells, 1, "one rounded work per cell and step, of the size of the energy"});
    check.holds(name + ": the volume of every cell.", {worst(defects)},
                Roundoff{steps, half_width, "positions up to 10, rounded per step, depth and width 1"});
  }
}

TEST_CASE("water in a parabolic canal swings with Thacker's frequency", "[conservation]") {
  Check check("shoreline_swing_2dh", "Water that swings in a parabolic canal, in 2DH",
              "Thacker (1981): in shallow water the surface stays a plane and the water moves as a whole, with "
              "frequency sqrt(2)/10 here. Dispersion adds terms of the order of (depth/half width)^2.",
              "Thacker, J. Fluid Mech. 107 (1981) 499");
  const double period = 2 * std::numbers::pi * half_width / std::sqrt(2.0);
  auto& panel =
      check.figure("swing", "The western shore", "Position of the node over one period; columns of 1, 1/2, 1/4.")
          .panel({.x = "t/period", .y = "x + 10 [depth]"});
  for (const std::size_t columns : {20, 40, 80}) {
    Flow flow(moved_water(columns, 0.5));
    std::vector<double> time, shore, swing;
    march(flow, period, 2 / static_cast<double>(columns), [&] {
      time.push_back(flow.time() / period);
      shore.push_back(flow.x()[0] + half_width);
      swing.push_back(0.5 * std::cos(2 * std::numbers::pi * time.back()));
    });
    panel.line(fmt::format("{} columns", columns), time, shore);
    if (columns < 80) continue;
    panel.line("Thacker", time, swing, Role::exact);
    check.that("swing", "The shoreline position agrees with Thacker's exact solution to the order of dispersion.",
               "largest difference over the amplitude",
               {.value = largest_difference(shore, swing) / 0.5, .resolution = "80 columns"},
               Bound{0.06, "dispersion: 2 pi times (1/10)^2"});
  }
}

TEST_CASE("invalid shorelines are rejected", "[robustness]") {
  Lattice level = rectangular_lattice({.end = 4, .north = 2, .columns = 4, .rows = 2});
  level.sides.west = ShoreSide{};
  CHECK_THROWS_AS(Flow(level), std::invalid_argument);
  Lattice wet = moved_water(20, 0);
  wet.z[0] += 0.01;
  CHECK_THROWS_AS(Flow(wet), std::invalid_argument);
  Lattice window = moved_water(20, 0);
  CHECK_THROWS_AS(Flow(window, {}, {}, {}, {}, {.reach = [](double) { return 0.0; }}), std::invalid_argument);
}

}  // namespace seiche::verification::shoreline_2dh_test
