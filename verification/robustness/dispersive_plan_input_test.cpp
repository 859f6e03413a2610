// What the plan model refuses: with name, value and range.
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "verification/polynomial_bottom.hpp"
#include "verification/robustness/refusals.hpp"

namespace dispersive_plan_input_test {

using namespace seiche;
using namespace seiche::dispersive_shallow_water_2d;
using namespace seiche::verification;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Rectangle still_water() {
  return {.begin = 0, .end = 4, .south = 0, .north = 3, .columns = 4, .rows = 3};
}

/// Defined for x < 3 only.
class ShortBottom final : public PlanBottom {
 public:
  [[nodiscard]] Slope slope(double x, double y) const override {
    require_inside(x, y);
    return {.elevation = -1};
  }
  [[nodiscard]] Integral integral(double x, double y) const override {
    require_inside(x, y);
    return {.elevation = -1, .value = -x};
  }

 private:
  static void require_inside(double x, double y) {
    if (!(x < 3)) throw OutsidePlanBottom(x, y, "x", -infinite, 3);
  }
};

TEST_CASE("bad lattices and settings of the plan model are refused with name, value and range", "[robustness]") {
  Check check("dispersive_plan_input", "Bad input of the two-dimensional horizontal model",
              "A lattice of 4 x 3 cells with one thing wrong at a time: its rectangle, its nodes, its sides, its "
              "bottom, its settings, its steps.");
  Refusals refusals(check);
  const auto rectangle = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      Rectangle r = still_water();
      change(r);
      Flow flow(rectangular_lattice(r));
    });
  };
  rectangle("A rectangle of no length.", {"end = 0", "above 0"}, [](Rectangle& r) { r.end = 0; });
  rectangle("A rectangle of no width.", {"north = -1", "above 0"}, [](Rectangle& r) { r.north = -1; });
  rectangle("A rectangle without an end.", {"end", "inf", "finite"}, [](Rectangle& r) { r.end = infinite; });
  rectangle("A single column.", {"columns", "= 1", "at least 2"}, [](Rectangle& r) { r.columns = 1; });
  rectangle("No rows.", {"rows", "= 0", "at least 1"}, [](Rectangle& r) { r.rows = 0; });
  rectangle("No depth.", {"depth", "0", "positive"}, [](Rectangle& r) { r.depth = 0; });
  rectangle("A depth that is not a number.", {"depth", "nan", "positive"},
            [](Rectangle& r) { r.depth = not_a_number; });
  rectangle("A surface below the bottom.", {"z = -1.5", "(2, 0)", "above the bottom", "-1"},
            [](Rectangle& r) { r.elevation = [](double x, double) { return x < 2 ? 0 : -1.5; }; });
  rectangle("A bottom above the surface.", {"z = 0", "(3, 0)", "above the bottom", "0.5"}, [](Rectangle& r) {
    r.bottom = std::make_shared<PolynomialBottom>(
        std::vector<PolynomialBottom::Term>{{.coefficient = -1}, {.coefficient = 0.5, .x_power = 1}});
    r.elevation = [](double x, double) { return x > 2 ? 0 : 0.2; };
  });
  rectangle("A surface that is not a number.", {"z[0]", "nan", "finite"},
            [](Rectangle& r) { r.elevation = [](double, double) { return not_a_number; }; });
  rectangle("A bottom that ends before the water.", {"(3, 0)", "outside the bottom", "x within"},
            [](Rectangle& r) { r.bottom = std::make_shared<ShortBottom>(); });
  const auto lattice = [&](const std::string& text, const std::vector<std::string>& words, auto change) {
    refusals.refused(text, words, [&] {
      Lattice l = rectangular_lattice(still_water());
      change(l);
      Flow flow(std::move(l));
    });
  };
  lattice("A node without an elevation.", {"z has 19 values", "20", "4 x 3"}, [](Lattice& l) { l.z.pop_back(); });
  lattice("A node whose place is not a number.", {"x[7]", "nan", "finite"}, [](Lattice& l) { l.x[7] = not_a_number; });
  lattice("A cell whose corner is turned over.", {"cell", "not convex", "anticlockwise"},
          [](Lattice& l) { l.x[l.shape.node(1, 1)] = 2.5; });
  lattice("Rows that go south.", {"cell 0", "not convex", "y with the row"}, [](Lattice& l) {
    for (double& y : l.y) y = -y;
  });
  lattice("A driven side without a velocity.", {"driven side", "no velocity"},
          [](Lattice& l) { l.sides.north = plan_lattice::DrivenSide{}; });
  lattice("A wall that bends outwards.", {"bends outwards", "(2, 0)", "180"}, [](Lattice& l) {
    for (std::size_t i = 0; i <= 4; ++i) l.y[i] = i > 2 ? -0.2 * static_cast<double>(i - 2) : 0;
  });
  const auto settings = [&](const std::string& text, const std::vector<std::string>& words, Settings bad) {
    refusals.refused(text, words, [&] { Flow flow(rectangular_lattice(still_water()), {}, {}, bad); });
  };
  settings("Negative gravity.", {"gravity", "-1"}, {.gravity = -1});
  settings("Gravity that is not a number.", {"gravity", "nan"}, {.gravity = not_a_number});
  settings("Negative friction.", {"manning", "-1", "non-negative"}, {.drag = {.manning = -1}});
  settings("A force along a shore where there is none.", {"shore_rate", "shoreline", "south"},
           {.drag = {.shore_rate = 1}});
  settings("A surface that breaks before it is steep.", {"breaking_slope", "-1", "non-negative"},
           {.drag = {.breaking_slope = -1}});
  settings("A pattern that is driven.", {"lattice_rate", "-1", "non-negative"}, {.drag = {.lattice_rate = -1}});
  settings("A layer that gives energy.", {"absorption", "-1", "non-negative"},
           {.drag = {.absorption = [](Point at) { return at.x - 1; }}});
  settings("Improved dispersion the wrong way.", {"gamma", "-0.1", "non-negative"}, {.gamma = -0.1});
  settings("No vertical inertia.", {"inertia", "0", "[0.001, 1]"}, {.inertia = 0});
  settings("A tolerance too loose.", {"tolerance", "0.1"},
           {.solver = linear::SolverMethod::iterative, .tolerance = 0.1});
  refusals.refused("Velocities that are not numbers.", {"u[0]", "nan", "finite"}, [] {
    Flow flow(rectangular_lattice(still_water()), [](double, double) { return Velocity{not_a_number, 0, 0}; });
  });
  refusals.refused("Velocities that are not as many as the nodes.", {"19 velocities", "20"},
                   [] { Flow flow(rectangular_lattice(still_water()), std::vector<Velocity>(19)); });
  refusals.refused("A moving window with a free rear.", {"moving window", "WallSide, HeldSide"}, [] {
    Rectangle free_rear = still_water();
    free_rear.sides.west = plan_lattice::FreeSide{};
    Flow flow(rectangular_lattice(free_rear), {}, {}, {}, {}, {.reach = [](double t) { return t; }});
  });
  refusals.refused("A moving window beside a wall that bends.", {"moving window", "north wall", "(2, 3)"}, [] {
    Lattice bent = rectangular_lattice(still_water());
    bent.y[bent.shape.node(3, bent.shape.rows)] -= 0.1;
    bent.y[bent.shape.node(4, bent.shape.rows)] -= 0.2;
    Flow flow(std::move(bent), {}, {}, {}, {}, {.reach = [](double t) { return t; }});
  });
  refusals.refused("A moving window with a layer that stays.", {"moving window", "absorption"}, [] {
    Flow flow(rectangular_lattice(still_water()), {}, {}, {.drag = {.absorption = [](Point) { return 1.0; }}}, {},
              {.reach = [](double t) { return t; }});
  });
  refusals.refused("A step that is not positive.", {"tau", "-0.1", "positive"}, [] {
    Flow flow(rectangular_lattice(still_water()));
    flow.advance(-0.1);
  });
  refusals.refused("A step that is not a number.", {"tau", "nan", "positive"}, [] {
    Flow flow(rectangular_lattice(still_water()));
    flow.advance(not_a_number);
  });
}

TEST_CASE("steps of the plan model beyond stability are counted", "[robustness]") {
  Check check("dispersive_plan_stability", "Two-dimensional horizontal model: steps beyond stability",
              "The longest stable step is at least 2/omega of the fastest mode, $\\omega < \\sqrt{g/(\\alpha H)}$, "
              "whatever the cells. Longer steps are a warning, not an error: small waves may not notice.");
  Flow flow(rectangular_lattice({.begin = 0, .end = 1, .south = 0, .north = 1, .columns = 20, .rows = 20}));
  check.holds("The bound of the step agrees with the fastest mode.", {flow.stable_step() / (2 * std::sqrt(1.0 / 3))},
              Bound{0.01, "omega^2 = g H K^2/(1 + alpha H^2 K^2), K^2 = 3200 for cells of 0.05", 1, true});
  flow.advance(0.5 * flow.stable_step());
  flow.advance(1.01 * flow.stable_step());
  check.holds("Steps longer than the bound are counted.", {static_cast<double>(flow.steps_beyond_stability())},
              Bound{0, "one of two", 1});
}

}  // namespace dispersive_plan_input_test
