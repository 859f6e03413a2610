// How runs of the 2DH model break down: with reason, time, step and place, and the state of before.
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "verification/conservation/dispersive_2dh_problems.hpp"
#include "verification/robustness/breakdown.hpp"

namespace seiche::verification::dispersive_2dh_breakdown_test {

using namespace dispersive_shallow_water_2d;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A square of water 1 deep that stands in water of some depth, without sides.
Rectangle block(double depth) {
  Rectangle square = free_square();
  square.elevation = [=](double, double) { return 1 - depth; };
  square.depth = depth;
  return square;
}

TEST_CASE("meshes that tangle, touch their bottom or leave it stop with time, step and position", "[robustness]") {
  Check check("dispersive_2dh_breakdown", "Breakdown of the two-dimensional horizontal model",
              "An eddy shears the mesh until a cell is inverted; a block of water collapses until its edge touches the "
              "level bottom; it spreads until it leaves an uneven bottom that ends; a driven side gives a velocity "
              "that is not a number. Each run stops there with every scheme and reports cause, time and position.");
  const auto turning = [](double x, double y) {
    const double k = std::numbers::pi / 10;
    return Velocity{0.5 * std::sin(k * x) * std::cos(k * y), -0.5 * std::cos(k * x) * std::sin(k * y), 0};
  };
  for (const auto& [name, scheme] : {std::pair{std::string("one-step"), Scheme{.stepping = Stepping::one_step}},
                                     {"conservative", {.stepping = Stepping::conservative}}}) {
    Flow eddy(rectangular_lattice({.end = 10, .north = 10, .columns = 20, .rows = 20}), turning, scheme);
    holds_of_breakdown(check, name + "-eddy", run_until_breakdown(eddy, 60, 0.1), "mesh tangled", -0.5, 10.5);
    Flow collapse(rectangular_lattice(block(0.02)), {}, scheme);
    holds_of_breakdown(check, name + "-collapse", run_until_breakdown(collapse, 60, 0.02), "touches the bottom", -20,
                       20);
    Rectangle over_short = block(0.5);
    over_short.bottom = std::make_shared<EndingBottom>(0.5, -7, 7);
    Flow spread(rectangular_lattice(over_short), {}, scheme);
    const Breakdown left = run_until_breakdown(spread, 60, 0.05);
    holds_of_breakdown(check, name + "-spread", left, "outside the bottom", -infinite, infinite);
    check.holds(name + "-spread-end: The reported position is beyond the end of the bed.", {std::abs(left.place)},
                Bound{0.2, "one step's way beyond the end", 7.1});
    Rectangle driven{.begin = 0, .end = 10, .north = 5, .columns = 20, .rows = 10};
    driven.sides.west = plan_lattice::DrivenSide{[](Place, double time) {
      return Point{time < 1 ? 0.1 * time : std::numeric_limits<double>::quiet_NaN(), 0};
    }};
    Flow bad_side(rectangular_lattice(driven), {}, scheme);
    holds_of_breakdown(check, name + "-side", run_until_breakdown(bad_side, 60, 0.1), "not finite", 0, 10);
  }
}

}  // namespace seiche::verification::dispersive_2dh_breakdown_test
