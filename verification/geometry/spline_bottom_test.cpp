// The bottom through elevations on a grid: order, exactness, and lakes at rest over it.
#include "seiche/geometry/plan_bottom.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/difference.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::spline_bottom_test {

const std::string source = "de Boor, J. Math. and Phys. 41 (1962) 212";

double hill(double x, double y) {
  return -1 + 0.4 * std::exp(-0.3 * (x - 5) * (x - 5)) * (1 + 0.5 * std::sin(0.6 * y));
}

SplineBottom hill_bottom(double spacing) {
  return SplineBottom::sampled({.begin = -1, .end = 11, .south = -1, .north = 11, .spacing = spacing}, hill);
}

/// Places off the grid, up to the ends.
template <class Work>
void over_places(const Work& work) {
  for (double x = -1; x <= 11; x += 0.173) {
    for (double y = -0.98; y <= 11; y += 0.191) work(x, y);
  }
}

TEST_CASE("a spline bottom is fourth-order accurate and consistent with its integral", "[geometry]") {
  Check check("spline_bottom", "Bottom through elevations on a grid",
              "A hill 0.4 high, spacings 1/4 to 1/32, elevations in the middles of its cells, slopes at 4300 "
              "positions. Values converge with order 4, slopes with order 3.",
              source);
  const std::string halvings = "three halvings from seven cells per width of the hill";
  refine(check, {"spacing", falling(0.25, 4)},
         {{"order", "Elevations of the spline bottom are of order 4.", {4, 0.3, halvings}},
          {"slope-order", "Slopes of the spline bottom are of order 3.", {3, 0.3, halvings}}},
         [](double spacing) {
           const SplineBottom bottom = hill_bottom(spacing);
           Worst value, slope;
           for (double x = -1 + spacing / 2; x < 11; x += spacing) {
             for (double y = -1 + spacing / 2; y < 11; y += spacing) {
               value.add(bottom.slope(x, y).elevation - hill(x, y));
             }
           }
           over_places([&](double x, double y) {
             const double rate = -0.6 * (x - 5) * (hill(x, y) + 1);
             slope.add(bottom.slope(x, y).along_x - rate);
           });
           return std::array{value.value(), slope.value()};
         });

  const auto cubic = [](double x, double y) {
    return -2 + x * (0.3 + y * (0.1 - 0.02 * x * y * y)) + 0.01 * x * x * x;
  };
  const std::vector<double> columns{0, 0.7, 1.1, 2, 3.5}, rows{-1, 0, 0.4, 1.5, 2};
  std::vector<double> elevation;
  for (const double y : rows) {
    for (const double x : columns) elevation.push_back(cubic(x, y));
  }
  const SplineBottom polynomial(columns, rows, elevation);
  Worst worst;
  for (double x = 0; x <= 3.5; x += 0.31) {
    for (double y = -1; y <= 2; y += 0.23) worst.add(polynomial.slope(x, y).elevation - cubic(x, y));
  }
  check.that("cubic", "Cubic polynomials on uneven grids are exact.", "largest error", {worst.value()},
             Roundoff{200, 4, "two solves of five slopes, elevations up to 4"});

  const SplineBottom bottom = hill_bottom(0.5);
  Worst rate, across;
  constexpr double h = 1e-3;
  over_places([&](double x, double y) {
    // Five-point differences do not see cubics' rounding errors larger than 1e-13/h; kinks of third derivatives are
    // avoided by staying within one cell.
    const auto cell = [](double place) { return std::floor(2 * place); };
    if (cell(x - 2 * h) != cell(x + 2 * h) || cell(y - 2 * h) != cell(y + 2 * h) || x < -0.99 || x > 10.99) return;
    const auto integral = bottom.integral(x, y);
    rate.add(difference([&](double d) { return bottom.integral(x + d, y).value; }, 2 * h) -
             bottom.slope(x, y).elevation);
    rate.add(integral.elevation - bottom.slope(x, y).elevation);
    across.add(difference([&](double d) { return bottom.integral(x, y + d).value; }, 2 * h) - integral.along_y);
  });
  const Bound differences{1e-11,
                          "values up to 12 rounded to 2e-15, divided by h = 1e-3; the formula is exact for quartics"};
  check.that("integral", "The rate of the integral along x is the bottom within 1e-11.", "largest difference",
             {rate.value()}, differences);
  check.that("integral-across", "The rate of the integral along y equals its stated derivative within 1e-11.",
             "largest difference", {across.value()}, differences);
}

TEST_CASE("over a spline bottom still water stays at rest and energy is conserved", "[conservation]") {
  using namespace dispersive_shallow_water_2d;
  Check check("spline_bottom_flow", "Waves over a bottom through elevations on a grid",
              "A hill under water in a box of 10 h x 10 h, elevations every 0.5. Inner edges cancel between cells, so "
              "that still water feels a force only along the walls across x, from the error of the edges' integral "
              "there; a bottom that is level at those walls has none.",
              source);
  const auto bottom = std::make_shared<SplineBottom>(SplineBottom::sampled(
      {.begin = -1, .end = 11, .south = -1, .north = 11, .spacing = 0.5},
      [](double x, double y) { return -1 + 0.4 * std::exp(-(x - 5) * (x - 5) - 0.5 * (y - 5) * (y - 5)); }));
  Rectangle basin{.begin = 0, .end = 10, .north = 10, .columns = 20, .rows = 20, .bottom = bottom};
  Flow lake(rectangular_lattice(basin));
  for (int n = 0; n < 200; ++n) lake.advance(0.1);
  check.that("lake", "The velocity of a lake over the spline bottom is zero, without rounding.", "largest velocity",
             {.value = worst(lake.state().u), .resolution = "20 x 20 cells, 200 steps"},
             Bound{0, "z = 0 everywhere: potential energy has no gradient there"});
  basin.elevation = [](double x, double y) { return 0.1 * std::exp(-(x - 3) * (x - 3) - (y - 4) * (y - 4)); };
  Flow flow(rectangular_lattice(basin), {}, {.stepping = Stepping::conservative}, {.tolerance = 1e-13});
  const double energy = flow.energy();
  Worst defect;
  for (int n = 0; n < 50; ++n) {
    flow.advance(0.1);
    defect.add(flow.energy() / energy - 1);
  }
  check.that("energy", "The energy of a wave is conserved by the conservative scheme.", "largest relative error",
             {.value = defect.value(), .resolution = "20 x 20 cells, 50 steps"},
             Roundoff{50.0 * 400, 1, "one rounded work per cell and step"});
}

TEST_CASE("a spline bottom rejects bad grids and positions", "[robustness]") {
  const std::vector<double> four{0, 1, 2, 3};
  const std::vector<double> flat(16, -1.0);
  CHECK_THROWS_AS(SplineBottom({0, 1, 2}, four, std::vector<double>(12, -1.0)), std::invalid_argument);
  CHECK_THROWS_AS(SplineBottom({0, 1, 1, 3}, four, flat), std::invalid_argument);
  CHECK_THROWS_AS(SplineBottom(four, four, {1, 2, 3}), std::invalid_argument);
  std::vector<double> holed = flat;
  holed[5] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(SplineBottom(four, four, holed), std::invalid_argument);
  CHECK_THROWS_AS(SplineBottom::sampled({.begin = 0, .end = -1, .north = 1}, hill), std::invalid_argument);
  const SplineBottom bottom(four, four, flat);
  CHECK_THROWS_AS(bottom.slope(3.01, 1), Infeasible);
  CHECK_THROWS_AS(bottom.integral(1, -0.01), Infeasible);
  CHECK_THROWS_AS(bottom.slope(std::numeric_limits<double>::quiet_NaN(), 1), Infeasible);
}

TEST_CASE("the integral of a bottom grows along a path by the path's own integral, however short", "[geometry]") {
  Check check("bottom_increment_2dh", "Increments of the bottom's integral",
              "Between two positions the bottom's integral along x grows by the integral of its gradient along the "
              "path between them. Over long paths, across many cells of the grid, that is the difference of the two "
              "values; over short ones it is far more accurate than that difference.",
              source);
  const SplineBottom bottom = hill_bottom(0.5);
  Worst far, halves, near;
  over_places([&](double x, double y) {
    const double to_x = 10 - 0.8 * x, to_y = 10 - 0.9 * y;
    const double grown = bottom.increment(x, y, to_x - x, to_y - y);
    far.add(grown - (bottom.integral(to_x, to_y).value - bottom.integral(x, y).value));
    constexpr double dx = -3e-4, dy = 4e-4;
    if (x + dx < -1 || y + dy > 11) return;
    halves.add((bottom.increment(x, y, dx, dy) - bottom.increment(x, y, dx / 2, dy / 2) -
                bottom.increment(x + dx / 2, y + dy / 2, dx / 2, dy / 2)) /
               5e-4);
    const auto at = bottom.integral(x, y);
    near.add((bottom.increment(x, y, 1e-6 * dx, 1e-6 * dy) - 1e-6 * (at.elevation * dx + at.along_y * dy)) / 5e-10);
  });
  check.that("far", "The increment of the integral over a long distance equals the difference of its values.",
             "largest difference", {far.value()},
             Roundoff{48 * 12, 12, "up to 48 pieces of the way, each a sum of some 12 terms; values up to 12"});
  check.that("halves", "The increment of the integral over a short distance equals the sum over both halves.",
             "largest difference over the length of the way", {halves.value()},
             Roundoff{16, 12, "gradients of up to 12, at positions rounded to a unit in the last place of 11"});
  check.that("near", "The increment of the integral over a distance of 5e-10 equals gradient times distance.",
             "largest difference over the length of the way", {near.value()},
             Bound{1e-9,
                   "half the way times second derivatives below 4; a difference of two values would have their "
                   "round-off over the way, 4e-6"});
}

}  // namespace seiche::verification::spline_bottom_test
