/// Forces of gravity on the free surface: minus the gradient of (rho g/2) int z^2 dA over its bilinear patches.
#pragma once

#include <array>
#include <cstddef>

#include "seiche/linear/lattice_matrix.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Rows of surface nodes south and north of a row of patches, by axis.
struct PatchRows {
  std::array<const double*, 3> south, north;
};
inline constexpr std::size_t patch_forces = 12;

/// Forces of a row of patches on their corners, number 3 corner + axis.
/// @param weight  rho g, times the weight in a mean
void press_patches(std::size_t columns, const PatchRows& r, double weight, linear::RowBlocks::Row forces);

/// push += the forces of the rows of patches south and north of a row of columns + 1 nodes.
void gather_push(std::size_t columns, linear::RowBlocks::ConstRow south, linear::RowBlocks::ConstRow north,
                 const std::array<double*, 3>& push);

/// int z^2/2 dA over a row of patches.
double moment_of_row(std::size_t columns, const PatchRows& r);

}  // namespace seiche::lagrangian_mesh_3d
