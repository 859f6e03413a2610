/// A lattice of water seen from above, and what bounds it: common to the models of waves in three dimensions.
///
/// columns x rows cells; node (i, j), i = 0..columns, j = 0..rows, has index j (columns + 1) + i; x grows with i and y
/// with j, so that the corners of cell (i, j), index j columns + i, go around anticlockwise:
///
///     3 = (i, j+1)   2 = (i+1, j+1)                  north
///     0 = (i, j)     1 = (i+1, j)             west          east
///                                                    south
///
/// z is the elevation above still water, so that a lake at rest has multipliers 0 and stays at rest bit by bit.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/geometry/vector.hpp"

namespace seiche::plan_lattice {

using Place = Vector3;  ///< z: elevation above still water

/// A vertical wall along the polygon of the side's first nodes. Nodes slide along straight parts and are held where the
/// wall bends inwards (interior angle below 180 degrees). Bends outwards are not possible.
struct WallSide {};

/// Nodes keep their horizontal velocities, zero at the beginning, and go up and down: any curved wall, and the rear of
/// a moving window.
struct HeldSide {};

/// A wall that follows a given flow: nodes have its velocity along the normal of the chord between their neighbours,
/// and slide along the chord. Lets a known wave in.
struct DrivenSide {
  std::function<Point(Place place, double time)> velocity;  ///< horizontal [m/s]
};

/// Nothing holds the nodes.
struct FreeSide {};

/// The moving shoreline: nodes at depth zero, which slide on the bottom. Only dispersive_shallow_water_2d knows them.
struct ShoreSide {};

using Side = std::variant<WallSide, HeldSide, DrivenSide, FreeSide, ShoreSide>;

struct Sides {
  Side west = WallSide{};
  Side east = WallSide{};
  Side south = WallSide{};
  Side north = WallSide{};
};

/// Whether a side is of this kind.
template <class Kind>
bool any_side(const Sides& sides) {
  return std::holds_alternative<Kind>(sides.west) || std::holds_alternative<Kind>(sides.east) ||
         std::holds_alternative<Kind>(sides.south) || std::holds_alternative<Kind>(sides.north);
}

/// Numbers of the nodes and cells of a lattice.
struct Shape {
  std::size_t columns = 0;
  std::size_t rows = 0;

  [[nodiscard]] std::size_t nodes() const { return (columns + 1) * (rows + 1); }
  [[nodiscard]] std::size_t cells() const { return columns * rows; }
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return j * (columns + 1) + i; }
  /// Corners 0, 1, 2, 3 of a cell.
  [[nodiscard]] std::array<std::size_t, 4> corners(std::size_t cell) const {
    const std::size_t corner = node(cell % columns, cell / columns);
    return {corner, corner + 1, corner + columns + 2, corner + columns + 1};
  }

  static constexpr std::size_t outside = static_cast<std::size_t>(-1);
  [[nodiscard]] std::size_t edges() const { return columns * (rows + 1) + rows * (columns + 1); }
  /// visit(p, q, left, right) for every edge p -> q, with the cells on its left and right hand or `outside`: those
  /// along rows, row by row, then those across them, row by row.
  template <class Visit>
  void each_edge(const Visit& visit) const {
    for (std::size_t j = 0; j <= rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        visit(node(i, j), node(i + 1, j), j < rows ? j * columns + i : outside,
              j > 0 ? (j - 1) * columns + i : outside);
      }
    }
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t i = 0; i <= columns; ++i) {
        visit(node(i, j), node(i, j + 1), i > 0 ? j * columns + i - 1 : outside,
              i < columns ? j * columns + i : outside);
      }
    }
  }
};

/// Throws std::invalid_argument unless both are finite and the last one is larger.
void require_ascending(std::string_view first, double begin, std::string_view last, double end);
/// Throws std::invalid_argument for fewer columns than that, no rows or layers, arrays of places that are not as long
/// as `levels` of nodes, values that are not finite.
void require_places(const Shape& shape, long columns, std::size_t levels,
                    std::initializer_list<std::pair<std::string_view, std::span<const double>>> places);

/// Node k of n + 1 at equal distances; the last one is at `to` in every bit.
inline double equally_spaced(double from, double to, std::size_t k, std::size_t n) {
  return k == n ? to : from + (to - from) * (static_cast<double>(k) / static_cast<double>(n));
}

/// In plan, of a cell with corners at (x, y): from its diagonals.
inline double cell_area(const Shape& shape, std::span<const double> x, std::span<const double> y, std::size_t cell) {
  const auto [c0, c1, c2, c3] = shape.corners(cell);
  return 0.5 * ((x[c2] - x[c0]) * (y[c3] - y[c1]) - (x[c3] - x[c1]) * (y[c2] - y[c0]));
}

/// What the sides forbid a node: its horizontal velocity along one direction, or along two; on a shoreline, to leave
/// the bottom.
struct BoundNode {
  std::size_t node = 0;
  std::size_t directions = 0;                         ///< 1 or 2, on a shoreline 0 too
  std::array<Point, 2> normal{};                      ///< unit vectors; of driven sides those of the first lattice
  std::array<const DrivenSide*, 2> driven{};          ///< null: at rest along that normal
  std::array<std::array<std::size_t, 2>, 2> chord{};  ///< of driven sides: neighbours on the side
  bool shore = false;

  [[nodiscard]] bool is_driven() const { return driven[0] != nullptr || driven[1] != nullptr; }
};

/// The nodes that sides bind, in ascending order. `sides` must outlive the result.
///
/// @param shores  whether the model knows shorelines
/// Throws std::invalid_argument: a wall that bends outwards (with the place), a side whose nodes coincide, a driven
/// side without a velocity, a shoreline where the model knows none.
std::vector<BoundNode> bound_nodes(Shape shape, const Sides& sides, std::span<const double> x,
                                   std::span<const double> y, bool shores = false);

/// Nodes of the south, east, north and west side in the order of a walk around the lattice with the water on the left.
std::array<std::vector<std::size_t>, 4> nodes_around(Shape shape);

/// Edges of shorelines, with the water on the left.
std::vector<std::array<std::size_t, 2>> shore_edges(Shape shape, const Sides& sides);

/// Unit normal of the chord between two nodes.
Point chord_normal(const std::array<std::size_t, 2>& chord, std::span<const double> x, std::span<const double> y);

}  // namespace seiche::plan_lattice
