/// A quadrilateral mesh of water in the vertical plane and what bounds it.
///
/// columns x rows cells; node (i, j), i = 0..columns, j = 0..rows, has index j (columns + 1) + i: rows of nodes are
/// contiguous, row 0 is the bottom, row `rows` the surface. Cell (i, j), index j columns + i, has the corners
///
///     r3 = (i, j+1)   r2 = (i+1, j+1)
///     r0 = (i, j)     r1 = (i+1, j)
///
/// y counts from the still-water level, so that a lake at rest has multipliers 0 and stays at rest bit by bit.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/lattice/cell_rows.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::lagrangian_mesh_2d {

/// Nothing holds the nodes.
struct FreeSide {};

/// Nodes slide along a curve. Vertical and horizontal lines cost nothing.
struct Wall {
  std::shared_ptr<const Curve> curve;
};

/// A vertical wall that moves: nodes are at x = place(t) and slide in y. A piston wavemaker.
struct MovingWall {
  std::function<double(double time)> place;
  std::function<double(double time)> velocity;
};

/// Nodes follow given paths; `label` is the node's initial position.
struct PrescribedSide {
  std::function<Point(Point label, double time)> position;
  std::function<Point(Point label, double time)> velocity;
};

using Side = std::variant<FreeSide, Wall, MovingWall, PrescribedSide>;

struct Sides {
  Side left = FreeSide{};
  Side right = FreeSide{};
  Side bottom = FreeSide{};
  Side top = FreeSide{};
};

/// Whether two sides are one wall, along a common curve: nodes then slide from one to the other.
bool joined(const Side& one, const Side& other);

/// Walls x = place and y = level.
Wall vertical_wall(double place);
Wall level_wall(double level);

struct Mesh : plan_lattice::Shape {
  std::vector<double> x, y;  ///< of (columns + 1)(rows + 1) nodes [m]
  Sides sides;

  /// Whether a corner of a cell is one of the mesh, between joined sides.
  [[nodiscard]] bool on_joined_sides(std::size_t cell, std::size_t corner) const;

  /// Throws std::invalid_argument: no cells, arrays of other lengths, values that are not finite, a corner that is not
  /// convex (by cell), a node that is off its wall by more than 1e-12 of the mesh's size, missing functions.
  void require_valid() const;
};

/// Twice the smallest triangle at a corner of a cell; over the cell's first area it is the corner's shape: 1 for a
/// rectangle, 0 where the corner is about to invert. A corner of the mesh between joined sides is left out: it is flat
/// where the wall is straight; should its node pass one of its neighbours, that one's corner inverts.
double least_triangle(const Mesh& mesh, std::span<const double> x, std::span<const double> y, std::size_t cell);

/// A quadrilateral cell of the mesh. Its two half diagonals a = (r2 - r0)/2 and b = (r3 - r1)/2 are all that its
/// gradients need:
///
///     dV/dr0 = (-by, bx) = -dV/dr2,   dV/dr1 = (ay, -ax) = -dV/dr3,   V = 2 (ax by - bx ay)
struct Quadrilateral {
  static constexpr std::size_t axes = 2, corners = 4, stored = 4, mobilities = 2, momenta = 2, turns = 1;

  SEICHE_INLINE static double gradient(std::size_t corner, std::size_t axis, const double* s, std::ptrdiff_t stride,
                                       std::ptrdiff_t i) {
    const auto number = static_cast<std::ptrdiff_t>(corner % 2 == 0 ? 3 - axis : 1 - axis);  // of ax, ay, bx, by
    const bool positive = (corner == 1 || corner == 2) == (axis == 0);
    return positive ? s[number * stride + i] : -s[number * stride + i];
  }
  SEICHE_INLINE static double rate(const double* s, std::ptrdiff_t stride, const auto& u, std::ptrdiff_t i) {
    return s[2 * stride + i] * (u[1][0][i] - u[1][1][i + 1]) - s[3 * stride + i] * (u[0][0][i] - u[0][1][i + 1]) +
           s[stride + i] * (u[0][0][i + 1] - u[0][1][i]) - s[i] * (u[1][0][i + 1] - u[1][1][i]);
  }

  static void run(const lattice::RowLoop<Quadrilateral>& loop);
};

/// Half diagonals of a row of cells between rows of nodes; returns the smallest of twice the corner triangles' areas.
double measure_row(std::size_t columns, const lattice::NodeVectors<Quadrilateral>& r, linear::RowBlocks::Row diagonals);

}  // namespace seiche::lagrangian_mesh_2d
