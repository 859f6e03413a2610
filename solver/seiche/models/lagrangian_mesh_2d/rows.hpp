/// The loops of the mesh over one row of cells or nodes: contiguous, without branches, compiled for wide registers.
///
/// A cell's two half diagonals a = (r2 - r0)/2 and b = (r3 - r1)/2 are all that its gradients need:
///
///     dV/dr0 = (-by, bx) = -dV/dr2,   dV/dr1 = (ay, -ax) = -dV/dr3,   V = 2 (ax by - bx ay)
#pragma once

#include <cstddef>

#include "seiche/linear/lattice_matrix.hpp"

namespace seiche::lagrangian_mesh_2d {

/// Half diagonals of all cells.
struct Diagonals {
  Diagonals() = default;
  Diagonals(std::size_t columns, std::size_t rows)
      : ax(columns, rows), ay(columns, rows), bx(columns, rows), by(columns, rows) {}
  linear::LatticeArray ax, ay, bx, by;
};

/// Nodes on the lower and upper side of a row of cells.
struct NodeRows {
  const double* lower;
  const double* upper;
};

/// Half diagonals of the row whose first cell is `first`; returns the smallest of twice the corner triangles' areas.
double measure_row(std::size_t columns, std::size_t first, NodeRows x, NodeRows y, Diagonals& diagonals);

/// Rates of the areas of a row: J u.
void rates_of_row(std::size_t columns, std::size_t first, const Diagonals& diagonals, NodeRows u, NodeRows v,
                  double* rates);

/// Coefficients of A = J W J^T of a row; `wx`, `wy` are the inverse masses of its nodes. Those towards the row above
/// are left alone if there is none.
void assemble_row(std::size_t columns, std::size_t first, bool has_row_above, const Diagonals& diagonals, NodeRows wx,
                  NodeRows wy, linear::NinePointMatrix& matrix);

/// u += W J^T mu for a row of columns + 1 nodes between the cells below (from `below` on) and above (from `above`);
/// `mu_below` and `mu_above` point to zeros where there are no cells.
void react_row(std::size_t columns, std::ptrdiff_t below, std::ptrdiff_t above, const Diagonals& diagonals,
               const double* mu_below, const double* mu_above, const double* wx, const double* wy, double* u,
               double* v);

}  // namespace seiche::lagrangian_mesh_2d
