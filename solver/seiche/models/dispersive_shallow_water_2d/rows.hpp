/// The loops of the plan model over one row of cells or nodes: contiguous, without branches, compiled for wide
/// registers.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "seiche/linear/lattice_matrix.hpp"

namespace seiche::dispersive_shallow_water_2d {

/// dV/dx, dV/dy, dV/dz of every cell with respect to its corners 0..3.
struct CellGradients {
  CellGradients() = default;
  CellGradients(std::size_t columns, std::size_t rows) {
    for (auto* along : {&x, &y, &z}) along->fill(linear::LatticeArray(columns, rows));
  }
  std::array<linear::LatticeArray, 4> x, y, z;
};

/// Inverse masses W of the nodes, symmetric 3 x 3.
struct InverseMasses {
  explicit InverseMasses(std::size_t nodes) {
    for (auto* w : {&xx, &yy, &zz, &xy, &xz, &yz}) w->assign(nodes, 0.0);
  }
  std::vector<double> xx, yy, zz, xy, xz, yz;
};

/// Nodes on the lower (south) and upper (north) side of a row of cells.
struct NodeRows {
  const double* lower;
  const double* upper;
};
struct PlaceRows {
  NodeRows x, y, z;
};
struct ForceRows {
  double* lower;
  double* upper;
};

/// Smallest corner Jacobian of a row and the smallest depth of its nodes.
struct RowExtremes {
  double jacobian;
  double depth;
};

/// Of the row whose first cell is `first`: gradients of the volumes over the level z = bottom, times `weight`, added to
/// what is there if `add`; forces of `gravity` on the nodes, times weight, added to `forces` along x, y and z.
///
/// @param scratch  12 x columns numbers
RowExtremes measure_row(std::size_t columns, std::size_t first, const PlaceRows& at, double bottom, double gravity,
                        double weight, bool add, CellGradients& gradients, const std::array<ForceRows, 3>& forces,
                        double* scratch);

/// Rates of the volumes of a row: J u.
void rates_of_row(std::size_t columns, std::size_t first, const CellGradients& gradients,
                  const std::array<NodeRows, 3>& velocity, double* rates);

/// Coefficients of A = J W J^T of the row of cells above the nodes from `lower` on. Those towards the row above are
/// left alone if there is none. @param full  whether W has entries off its diagonal in these rows of nodes
void assemble_row(std::size_t columns, std::size_t first, std::size_t lower, bool full, bool has_row_above,
                  const CellGradients& gradients, const InverseMasses& w, linear::NinePointMatrix& matrix);

/// u += W J^T mu for the row of columns + 1 nodes from `node` on, between the cells from `below` and from `above` on;
/// mu_below and mu_above point to zeros where there are no cells.
void react_row(std::size_t columns, std::size_t node, bool full, std::ptrdiff_t below, std::ptrdiff_t above,
               const CellGradients& gradients, const double* mu_below, const double* mu_above, const InverseMasses& w,
               const std::array<double*, 3>& velocity);

/// u += h W f for a row of `count` nodes from `node` on.
void kick_row(std::size_t count, std::size_t node, bool full, double h, const std::array<const double*, 3>& force,
              const InverseMasses& w, const std::array<double*, 3>& velocity);

}  // namespace seiche::dispersive_shallow_water_2d
