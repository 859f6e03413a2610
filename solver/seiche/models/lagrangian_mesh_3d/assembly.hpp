/// Coefficients of A = J W J^T, one row of cells at a time.
#pragma once

#include <cstddef>

#include "seiche/models/lagrangian_mesh_3d/rows.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Rows of cells that come after a row, and whether they are there: (j+1, l), (j-1, l+1), (j, l+1), (j+1, l+1).
struct LaterRows {
  RowBlocks::ConstRow north;
  std::array<RowBlocks::ConstRow, 3> above;
  bool has_north;
  std::array<bool, 3> has_above;
};

/// Sets the coefficients of a row of cells with themselves (`own`) and with those after them (`later`, numbered by
/// linear::later_neighbour).
/// @param w  inverse masses of the nodes around the row
void assemble_row(std::size_t columns, RowBlocks::ConstRow gradients, const LaterRows& rows, const NodeVectors& w,
                  double* own, RowBlocks::Row later);

}  // namespace seiche::lagrangian_mesh_3d
