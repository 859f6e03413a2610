/// A quadrilateral cell of the mesh. Its two half diagonals a = (r2 - r0)/2 and b = (r3 - r1)/2 are all that its
/// gradients need:
///
///     dV/dr0 = (-by, bx) = -dV/dr2,   dV/dr1 = (ay, -ax) = -dV/dr3,   V = 2 (ax by - bx ay)
#pragma once

#include <cstddef>

#include "seiche/lattice/cell_rows.hpp"

namespace seiche::lagrangian_mesh_2d {

struct Quadrilateral {
  static constexpr std::size_t axes = 2, corners = 4, stored = 4, mobilities = 2, momenta = 2, turns = 1;

  template <std::size_t corner, std::size_t axis>
  SEICHE_INLINE static double gradient(const double* s, std::ptrdiff_t stride, std::ptrdiff_t i) {
    constexpr std::ptrdiff_t number = corner % 2 == 0 ? 3 - axis : 1 - axis;  // of ax, ay, bx, by
    constexpr bool positive = (corner == 1 || corner == 2) == (axis == 0);
    return positive ? s[number * stride + i] : -s[number * stride + i];
  }
  SEICHE_INLINE static double rate(const double* s, std::ptrdiff_t stride, const auto& u, std::ptrdiff_t i) {
    return s[2 * stride + i] * (u[1][0][i] - u[1][1][i + 1]) - s[3 * stride + i] * (u[0][0][i] - u[0][1][i + 1]) +
           s[stride + i] * (u[0][0][i + 1] - u[0][1][i]) - s[i] * (u[1][0][i + 1] - u[1][1][i]);
  }
  static void assemble_row(const lattice::Assembly<Quadrilateral>& row);
  static void rates_of_row(const lattice::Rates<Quadrilateral>& row);
  static void react_row(const lattice::Reaction<Quadrilateral>& row);
  static void kick_row(const lattice::Kick<Quadrilateral>& row);
};

/// Half diagonals of a row of cells between rows of nodes; returns the smallest of twice the corner triangles' areas.
double measure_row(std::size_t columns, const lattice::NodeVectors<Quadrilateral>& r, linear::RowBlocks::Row diagonals);

}  // namespace seiche::lagrangian_mesh_2d
