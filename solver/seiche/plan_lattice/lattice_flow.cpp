#include "seiche/plan_lattice/lattice_flow.hpp"

#include <cmath>
#include <stdexcept>
#include <tuple>

#include "seiche/require_that.hpp"

namespace seiche::plan_lattice {

namespace {

constexpr double straight = 1e-9;  // sine of the angle between a wall's edges: places are rounded to 1e-12 of an edge

}  // namespace

void require_movable(const Window& window, const Sides& sides) {
  require_that(
      !window.reach || std::holds_alternative<WallSide>(sides.west) || std::holds_alternative<HeldSide>(sides.west),
      "a moving window over a west side that is free or driven; allowed: WallSide, HeldSide");
}

void require_straight_walls(const Window& window, const Sides& sides, Shape shape, std::span<const double> x,
                            std::span<const double> y) {
  if (!window.reach) return;
  for (const auto& [side, row, name] :
       {std::tuple{&sides.south, std::size_t{0}, "south"}, std::tuple{&sides.north, shape.rows, "north"}}) {
    if (!std::holds_alternative<WallSide>(*side)) continue;
    const auto edge = [&, row = row](std::size_t i) {
      const std::size_t k = shape.node(i, row);
      return Point{x[k + 1] - x[k], y[k + 1] - y[k]};
    };
    const Point first = edge(0);
    for (std::size_t i = 1; i < shape.columns; ++i) {
      const Point next = edge(i);
      const double turn = cross(first, next) / (std::hypot(first.x, first.y) * std::hypot(next.x, next.y));
      const std::size_t k = shape.node(i, row);
      require_that(std::abs(turn) <= straight,
                   "a moving window beside a {} wall that bends at ({:g}, {:g}); allowed: straight walls", name, x[k],
                   y[k]);
    }
  }
}

}  // namespace seiche::plan_lattice
