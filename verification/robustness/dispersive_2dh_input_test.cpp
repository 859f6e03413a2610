// What the 2DH model refuses: with name, value and range.
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "verification/polynomial_bottom.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::dispersive_2dh_input_test {

using namespace dispersive_shallow_water_2d;

Rectangle still_water() {
  return {.begin = 0, .end = 4, .north = 3, .columns = 4, .rows = 3};
}

TEST_CASE("bad meshes and settings of the 2DH model are rejected with name, value and range", "[robustness]") {
  Check check("dispersive_2dh_input", "Bad input of the two-dimensional horizontal model",
              "A mesh of 4 x 3 cells with one error at a time: its rectangle, its nodes, its sides, its bottom, its "
              "settings, its steps.");
  Refusals refusals(check);
  const auto rectangle = refusals.of(still_water(), [&](Rectangle r) { Flow flow(rectangular_lattice(r)); });
  rectangle({"end = 0", "above begin = 0"}, [](Rectangle& r) { r.end = 0; });
  rectangle({"north = -1", "above south = 0"}, [](Rectangle& r) { r.north = -1; });
  rectangle({"end", "inf", "finite"}, [](Rectangle& r) { r.end = infinity; });
  rectangle({"columns", "= 1", "at least 2"}, [](Rectangle& r) { r.columns = 1; });
  rectangle({"rows", "= 0", "at least 1"}, [](Rectangle& r) { r.rows = 0; });
  rectangle({"depth", "0", "positive"}, [](Rectangle& r) { r.depth = 0; });
  rectangle({"depth", "nan", "positive"}, [](Rectangle& r) { r.depth = not_a_number; });
  rectangle({"z = -1.5", "(2, 0)", "above the bottom", "-1"},
            [](Rectangle& r) { r.elevation = [](double x, double) { return x < 2 ? 0 : -1.5; }; });
  rectangle({"z = 0", "(3, 0)", "above the bottom", "0.5"}, [](Rectangle& r) {
    r.bottom = polynomial_bottom({{.coefficient = -1}, {.coefficient = 0.5, .x_power = 1}});
    r.elevation = [](double x, double) { return x > 2 ? 0 : 0.2; };
  });
  rectangle({"z[0]", "nan", "finite"}, [](Rectangle& r) { r.elevation = [](double, double) { return not_a_number; }; });
  rectangle({"(3, 0)", "outside the bottom", "x within"},
            [](Rectangle& r) { r.bottom = std::make_shared<EndingBottom>(1, -1, 3); });
  const auto lattice = refusals.of(rectangular_lattice(still_water()), [&](Lattice l) { Flow flow(std::move(l)); });
  lattice({"z has 19 values", "20", "4 x 3"}, [](Lattice& l) { l.z.pop_back(); });
  lattice({"x[7]", "nan", "finite"}, [](Lattice& l) { l.x[7] = not_a_number; });
  lattice({"cell", "not convex", "anticlockwise"}, [](Lattice& l) { l.x[l.shape.node(1, 1)] = 2.5; });
  lattice({"cell 0", "not convex", "y with the row"}, [](Lattice& l) {
    for (double& y : l.y) y = -y;
  });
  lattice({"driven side", "no velocity"}, [](Lattice& l) { l.sides.north = plan_lattice::DrivenSide{}; });
  lattice({"bends outwards", "(2, 0)", "180"}, [](Lattice& l) {
    for (std::size_t i = 0; i <= 4; ++i) l.y[i] = i > 2 ? -0.2 * static_cast<double>(i - 2) : 0;
  });
  const auto use = [](const Settings& s) { Flow(rectangular_lattice(still_water()), {}, {}, s); };
  const auto settings = refusals.with<Settings>(use);
  refusals.outside_ranges("Settings",
                          "gravity non-negative and finite; inertia in [0.001, 1]; gamma non-negative and finite",
                          Settings{}, use);
  refusals.outside_ranges("DragSettings",
                          "manning non-negative and finite; shore_rate non-negative and finite; lattice_rate "
                          "non-negative and finite; breaking_slope non-negative and finite",
                          DragSettings{}, [&](const DragSettings& s) { use({.drag = s}); });
  settings({"shore_rate", "shoreline", "south"}, {.drag = {.shore_rate = 1}});
  settings({"absorption", "-1", "non-negative"}, {.drag = {.absorption = [](Point at) { return at.x - 1; }}});
  settings({"tolerance", "0.1"}, {.solver = linear::SolverMethod::iterative, .tolerance = 0.1});
  refusals.refused({"u[0]", "nan", "finite"}, [] {
    Flow flow(rectangular_lattice(still_water()), [](double, double) { return Velocity{not_a_number, 0, 0}; });
  });
  refusals.refused({"19 velocities", "20"},
                   [] { Flow flow(rectangular_lattice(still_water()), std::vector<Velocity>(19)); });
  const auto moving = [](const Lattice& l, const Settings& s = {}) {
    Flow flow(l, {}, {}, s, {}, {.reach = [](double t) { return t; }});
  };
  const auto window = refusals.of(rectangular_lattice(still_water()), [=](const Lattice& l) { moving(l); });
  window({"moving window", "WallSide, HeldSide"}, [](Lattice& l) { l.sides.west = plan_lattice::FreeSide{}; });
  window({"moving window", "north wall", "(2, 3)"}, [](Lattice& l) {
    l.y[l.shape.node(3, l.shape.rows)] -= 0.1;
    l.y[l.shape.node(4, l.shape.rows)] -= 0.2;
  });
  window({"moving window", "shoreline"}, [](Lattice& l) {
    Rectangle beach = still_water();
    beach.sides.south = plan_lattice::ShoreSide{};
    beach.bottom = polynomial_bottom({{.coefficient = -1, .y_power = 1}});
    l = rectangular_lattice(beach);
  });
  refusals.refused({"moving window", "absorption"}, [&] {
    moving(rectangular_lattice(still_water()), {.drag = {.absorption = [](Point) { return 1.0; }}});
  });
}

TEST_CASE("the longest stable step of the 2DH model follows from the fastest mode", "[robustness]") {
  Check check("dispersive_2dh_stability", "Two-dimensional horizontal model: the longest stable step",
              "The longest stable step is at least 2/omega of the fastest mode, $\\omega < \\sqrt{g/(\\alpha H)}$, "
              "whatever the cells.");
  Flow flow(rectangular_lattice({.end = 1, .north = 1, .columns = 20, .rows = 20}));
  check.holds("The bound of the step agrees with the fastest mode.", {flow.stable_step() / (2 * std::sqrt(1.0 / 3))},
              Bound{0.01, "omega^2 = g H K^2/(1 + alpha H^2 K^2), K^2 = 3200 for cells of 0.05", 1, true});
  // K^2 = 4/h1^2 + 4/h2^2 = 20 of oblong cells, however the lattice lies.
  Lattice oblong = rectangular_lattice({.end = 1, .north = 1, .columns = 2, .rows = 1});
  const double expected = 2 / std::sqrt(20 / (1 + 20.0 / 3));
  CHECK_THAT(Flow(oblong).stable_step(), Catch::Matchers::WithinRel(expected, 1e-12));
  for (std::size_t k = 0; k < oblong.x.size(); ++k) {
    const double x = oblong.x[k], y = oblong.y[k];
    oblong.x[k] = 0.6 * x - 0.8 * y;
    oblong.y[k] = 0.8 * x + 0.6 * y;
  }
  CHECK_THAT(Flow(oblong).stable_step(), Catch::Matchers::WithinRel(expected, 1e-12));
}

}  // namespace seiche::verification::dispersive_2dh_input_test
