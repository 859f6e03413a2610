#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_2d {

void Lattice::require_valid() const {
  require_at_least("columns", static_cast<long>(shape.columns), 2);
  require_at_least("rows", static_cast<long>(shape.rows), 1);
  require_positive("depth", depth);
  for (const auto& [name, values] : {std::pair{"x", &x}, std::pair{"y", &y}, std::pair{"z", &z}}) {
    require_that(values->size() == shape.nodes(), "{} has {} values; allowed: {}, one per node of {} x {} cells", name,
                 values->size(), shape.nodes(), shape.columns, shape.rows);
    const auto bad = std::find_if(values->begin(), values->end(), [](double value) { return !std::isfinite(value); });
    if (bad == values->end()) continue;
    throw std::invalid_argument(fmt::format("{}[{}] = {}; allowed: finite", name, bad - values->begin(), *bad));
  }
  const auto bottom_below = [this](double at_x, double at_y) {
    try {
      return bottom ? bottom->slope(at_x, at_y).elevation : -depth;
    } catch (const OutsidePlanBottom& outside) {
      throw std::invalid_argument(outside.what());
    }
  };
  std::vector<char> on_shore(shape.nodes(), 0);
  for (const auto& edge : plan_lattice::shore_edges(shape, sides)) {
    require_that(bottom != nullptr, "a shoreline over a level bottom; allowed: an uneven bottom");
    for (const std::size_t k : edge) on_shore[k] = 1;
  }
  std::vector<double> bed(shape.nodes());
  double deepest = 0;
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    bed[k] = bottom_below(x[k], y[k]);
    deepest = std::max(deepest, z[k] - bed[k]);
  }
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    const double under = bed[k];
    if (on_shore[k] != 0) {
      if (std::abs(z[k] - under) <= 1e-12 * deepest) continue;
      throw std::invalid_argument(
          fmt::format("z = {:.17g} at ({:g}, {:g}); allowed: the bottom's elevation {:.17g} to "
                      "1e-12 of the largest depth, it is on a shoreline",
                      z[k], x[k], y[k], under));
    }
    require_that(z[k] > under, "z = {:g} at ({:g}, {:g}); allowed: above the bottom, {:g}", z[k], x[k], y[k], under);
  }
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto corners = shape.corners(cell);
    const auto at = [&](std::span<const double> values) { return bilinear_patch::at_corners(values, corners); };
    require_that(bilinear_patch::smallest(bilinear_patch::jacobians(at(x), at(y))) > 0,
                 "cell {} at ({:g}, {:g}) is not convex, or its corners do not go around "
                 "anticlockwise; allowed: x grows with the column, y with the row",
                 cell, x[corners[0]], y[corners[0]]);
  }
}

Lattice rectangular_lattice(const Rectangle& rectangle) {
  for (const auto& [name, from, to] :
       {std::tuple{"end", rectangle.begin, rectangle.end}, std::tuple{"north", rectangle.south, rectangle.north}}) {
    require_finite(name, to);
    require_that(to > from, "{} = {:g}; allowed: above {:g}", name, to, from);
  }
  require_at_least("columns", static_cast<long>(rectangle.columns), 2);
  require_at_least("rows", static_cast<long>(rectangle.rows), 1);
  Lattice lattice{.shape = {rectangle.columns, rectangle.rows},
                  .x = {},
                  .y = {},
                  .z = {},
                  .sides = rectangle.sides,
                  .depth = rectangle.depth,
                  .bottom = rectangle.bottom};
  const auto between = [](double from, double to, std::size_t k, std::size_t n) {
    return k == n ? to : from + (to - from) * (static_cast<double>(k) / static_cast<double>(n));
  };
  for (std::size_t j = 0; j <= rectangle.rows; ++j) {
    for (std::size_t i = 0; i <= rectangle.columns; ++i) {
      lattice.x.push_back(between(rectangle.begin, rectangle.end, i, rectangle.columns));
      lattice.y.push_back(between(rectangle.south, rectangle.north, j, rectangle.rows));
      lattice.z.push_back(rectangle.elevation ? rectangle.elevation(lattice.x.back(), lattice.y.back()) : 0.0);
    }
  }
  return lattice;
}

}  // namespace seiche::dispersive_shallow_water_2d
