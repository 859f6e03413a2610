/// The loops of the mesh over one row of cells or nodes: contiguous, without branches, compiled for wide registers.
///
/// With corners at xi, eta, zeta = +-1 and the modes of their places
///
///     a, b, c = (1/8) sum (xi, eta, zeta) r,   d, e, f = (1/8) sum (eta zeta, zeta xi, xi eta) r,
///
/// the volume and its gradient at a corner are
///
///     V = 8 [det(a,b,c) + (det(e,d,c) + det(f,b,d) + det(a,f,e))/3]
///     dV/dr = xi A + eta B + zeta C + (eta zeta D + zeta xi E + xi eta F)/3
///     A = b x c + f x e/3   B = c x a + d x f/3   C = a x b + e x d/3
///     D = c x e + f x b     E = d x c + a x f     F = b x d + e x a
#pragma once

#include <array>
#include <cstddef>

#include "seiche/linear/lattice_matrix.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Number of a component of a cell's gradient in its row: axis x, y, z = 0, 1, 2.
constexpr std::size_t component(std::size_t corner, std::size_t axis) {
  return 3 * corner + axis;
}
inline constexpr std::size_t components = 24;

using linear::RowBlocks;

/// The four rows of nodes around a row of cells, of one quantity: (j, l), (j+1, l), (j, l+1), (j+1, l+1).
using NodeRows = std::array<const double*, 4>;
/// The same of a vector field.
using NodeVectors = std::array<NodeRows, 3>;

/// Gradients of the volumes of a row of cells.
void measure_row(std::size_t columns, const NodeVectors& r, RowBlocks::Row gradients);
/// gradients += factor times the gradients of a row of cells with these corners: volumes are cubic, so that their mean
/// gradient over r -> r + delta is that at the middle plus 1/12 of that of the cell `delta`.
void add_measured_row(std::size_t columns, const NodeVectors& r, double factor, RowBlocks::Row gradients);
/// Number of corners whose edges do not span a positive volume.
double folded_corners_of_row(std::size_t columns, const NodeVectors& r);

/// Rates of the volumes of a row: J u.
void rates_of_row(std::size_t columns, RowBlocks::ConstRow gradients, const NodeVectors& u, double* rates);

/// The four rows of cells around a row of nodes: (j-1, l-1), (j, l-1), (j-1, l), (j, l).
struct CellRows {
  std::array<RowBlocks::ConstRow, 4> gradients;
  std::array<const double*, 4> mu;  ///< zeros where there are no cells
};
/// u += W J^T mu for a row of columns + 1 nodes; w: their inverse masses along the axes.
void react_row(std::size_t columns, const CellRows& cells, const std::array<const double*, 3>& w,
               const std::array<double*, 3>& u);

}  // namespace seiche::lagrangian_mesh_3d
