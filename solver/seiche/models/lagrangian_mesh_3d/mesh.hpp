/// A hexahedral mesh of water and what bounds it.
///
/// columns x rows x layers cells; node (i, j, l) has index (l (rows + 1) + j)(columns + 1) + i: rows of nodes along x
/// are contiguous, level 0 is the bottom, level `layers` the surface. Cell (i, j, l), index (l rows + j) columns + i,
/// has the corners
///
///     7 = (i, j+1, l+1)   6 = (i+1, j+1, l+1)          3 = (i, j+1, l)   2 = (i+1, j+1, l)
///     4 = (i, j, l+1)     5 = (i+1, j, l+1)   above    0 = (i, j, l)     1 = (i+1, j, l)
///
/// Its shape is the trilinear hexahedron of its corners: faces are bilinear patches, which neighbours share and which
/// are the mean of the two ways to cut a face into triangles. z counts from the still-water level, so that a lake at
/// rest has multipliers 0 and stays at rest bit by bit. The bottom is level, or a smooth surface on which the nodes of
/// level 0 slide (nodes.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/geometry/vector.hpp"
#include "seiche/lattice/cell_rows.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::lagrangian_mesh_3d {

using plan_lattice::Place;
using plan_lattice::Shape;
using plan_lattice::Sides;

struct Mesh {
  Shape plan;
  std::size_t layers = 0;
  std::vector<double> x, y, z;  ///< of all nodes [m]
  Sides sides;                  ///< hold the nodes of all levels; driven ones in both horizontal directions
  bool free_bottom = false;     ///< nodes of level 0 move vertically too: a body of fluid in space
  std::shared_ptr<const PlanBottom> bottom = {};  ///< uneven; null: level

  [[nodiscard]] std::size_t nodes() const { return plan.nodes() * (layers + 1); }
  [[nodiscard]] std::size_t cells() const { return plan.cells() * layers; }
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j, std::size_t l) const {
    return l * plan.nodes() + plan.node(i, j);
  }
  /// Corners 0..7 of a cell.
  [[nodiscard]] std::array<std::size_t, 8> corners(std::size_t cell) const;

  /// Throws std::invalid_argument: no cells, arrays of other lengths, values that are not finite, a corner whose edges
  /// do not span a positive volume (by cell and place), a bottom node that is off the bottom by more than 1e-12 of the
  /// depth there, driven sides or a free bottom over an uneven one.
  void require_valid() const;

 private:
  void require_bottom() const;
};

using Vector = Vector3;
using CellCorners = std::array<Vector, 8>;

/// Volume of the trilinear hexahedron.
double hexahedron_volume(const CellCorners& r);
/// Volume spanned by the edges at each corner: positive for all of them if the cell is not inverted there; over the
/// cell's first volume it is the shape of the corner, 1 for a box.
std::array<double, 8> corner_volumes(const CellCorners& r);

CellCorners corners_of(const Mesh& mesh, std::span<const double> x, std::span<const double> y,
                       std::span<const double> z, std::size_t cell);

// A hexahedral cell of the mesh. With corners at xi, eta, zeta = +-1 and the modes of their places
//
//     a, b, c = (1/8) sum (xi, eta, zeta) r,   d, e, f = (1/8) sum (eta zeta, zeta xi, xi eta) r,
//
// the volume and its gradient at a corner are
//
//     V = 8 [det(a,b,c) + (det(e,d,c) + det(f,b,d) + det(a,f,e))/3]
//     dV/dr = xi A + eta B + zeta C + (eta zeta D + zeta xi E + xi eta F)/3
//     A = b x c + f x e/3   B = c x a + d x f/3   C = a x b + e x d/3
//     D = c x e + f x b     E = d x c + a x f     F = b x d + e x a

struct Hexahedron : lattice::StoredGradients {
  static constexpr std::size_t axes = 3, corners = 8, stored = 24, mobilities = 3, momenta = 3, turns = 3;

  static void run(const lattice::RowLoop<Hexahedron>& loop);
};

using NodeVectors = lattice::NodeVectors<Hexahedron>;
using linear::RowBlocks;

/// Gradients of the volumes of a row of cells, times `factor`, added to what is there if `add`: volumes are cubic, so
/// that their mean gradient over r -> r + delta is that at the middle plus 1/12 of that of the cell `delta`.
void measure_row(std::size_t columns, const NodeVectors& r, double factor, bool add, RowBlocks::Row gradients);
/// Number of corners whose edges do not span a positive volume.
double inverted_corners_of_row(std::size_t columns, const NodeVectors& r);

}  // namespace seiche::lagrangian_mesh_3d
