/// A hexahedral cell of the mesh. With corners at xi, eta, zeta = +-1 and the modes of their places
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

#include "seiche/lattice/cell_rows.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Gradients are kept as they are, number 3 corner + axis.
struct Hexahedron {
  static constexpr std::size_t axes = 3, corners = 8, stored = 24, mobilities = 3, momenta = 3, turns = 3;

  template <std::size_t corner, std::size_t axis>
  SEICHE_INLINE static double gradient(const double* s, std::ptrdiff_t stride, std::ptrdiff_t i) {
    return s[static_cast<std::ptrdiff_t>(3 * corner + axis) * stride + i];
  }
  static void assemble_row(const lattice::Assembly<Hexahedron>& row);
  static void rates_of_row(const lattice::Rates<Hexahedron>& row);
  static void react_row(const lattice::Reaction<Hexahedron>& row);
  static void kick_row(const lattice::Kick<Hexahedron>& row);
};

using NodeVectors = lattice::NodeVectors<Hexahedron>;
using linear::RowBlocks;

/// Gradients of the volumes of a row of cells.
void measure_row(std::size_t columns, const NodeVectors& r, RowBlocks::Row gradients);
/// gradients += factor times the gradients of a row of cells with these corners: volumes are cubic, so that their mean
/// gradient over r -> r + delta is that at the middle plus 1/12 of that of the cell `delta`.
void add_measured_row(std::size_t columns, const NodeVectors& r, double factor, RowBlocks::Row gradients);
/// Number of corners whose edges do not span a positive volume.
double folded_corners_of_row(std::size_t columns, const NodeVectors& r);

}  // namespace seiche::lagrangian_mesh_3d
