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
    const std::size_t first = shape.node(0, row);
    for (std::size_t k = first + 1; k < first + shape.columns; ++k) {
      const double turn = cross(chord_normal({first, first + 1}, x, y), chord_normal({k, k + 1}, x, y));
      require_that(std::abs(turn) <= straight,
                   "a moving window beside a {} wall that bends at ({:g}, {:g}); allowed: straight walls", name, x[k],
                   y[k]);
    }
  }
}

}  // namespace seiche::plan_lattice
