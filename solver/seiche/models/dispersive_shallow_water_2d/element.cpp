#include "seiche/models/dispersive_shallow_water_2d/element.hpp"

#include <algorithm>
#include <limits>

#include "seiche/geometry/bilinear_patch.hpp"

namespace seiche::dispersive_shallow_water_2d {

SEICHE_SIMD_CLONES
void Column::assemble_row(const lattice::Assembly<Column>& row) {
  if (row.full) {
    lattice::assemble<Column, true>(row);
  } else {
    lattice::assemble<Column, false>(row);
  }
}

SEICHE_SIMD_CLONES
void Column::rates_of_row(const lattice::Rates<Column>& row) {
  lattice::find_rates(row);
}

SEICHE_SIMD_CLONES
void Column::react_row(const lattice::Reaction<Column>& row) {
  if (row.full) {
    lattice::react<Column, true>(row);
  } else {
    lattice::react<Column, false>(row);
  }
}

SEICHE_SIMD_CLONES
void Column::kick_row(const lattice::Kick<Column>& row) {
  if (row.full) {
    lattice::kick<Column, true>(row);
  } else {
    lattice::kick<Column, false>(row);
  }
}

SEICHE_SIMD_CLONES
RowExtremes measure_row(std::size_t columns, const lattice::NodeVectors<Column>& rows, double bottom, double weight,
                        bool add, linear::RowBlocks::Row gradients) {
  using bilinear_patch::Corners;
  const lattice::NodeVectors<Column> r = rows;
  double* const g = gradients.data;
  const std::size_t stride = gradients.stride;
  double jacobian = std::numeric_limits<double>::infinity();
  double depth = std::numeric_limits<double>::infinity();
  if (!add) {
    for (std::size_t k = 0; k < Column::stored; ++k) std::fill_n(gradients[k], columns, 0.0);
  }
#pragma omp simd reduction(min : jacobian, depth)
  for (std::size_t i = 0; i < columns; ++i) {
    const auto corners = [&](std::size_t axis) __attribute__((always_inline)) {
      return Corners{r[axis][0][i], r[axis][0][i + 1], r[axis][1][i + 1], r[axis][1][i]};
    };
    const Corners x = corners(0);
    const Corners y = corners(1);
    const Corners z = corners(2);
    const Corners over{z.c0 - bottom, z.c1 - bottom, z.c2 - bottom, z.c3 - bottom};
    const Corners j = bilinear_patch::jacobians(x, y);
    const auto volume = bilinear_patch::volume_gradient(x, y, over, j);
    const auto put = [&](std::size_t axis, const Corners& along) __attribute__((always_inline)) {
      g[axis * stride + i] += weight * along.c0;
      g[(3 + axis) * stride + i] += weight * along.c1;
      g[(6 + axis) * stride + i] += weight * along.c2;
      g[(9 + axis) * stride + i] += weight * along.c3;
    };
    put(0, volume.x);
    put(1, volume.y);
    put(2, volume.z);
    jacobian = std::min(jacobian, std::min(std::min(j.c0, j.c1), std::min(j.c2, j.c3)));
    depth = std::min(depth, std::min(std::min(over.c0, over.c1), std::min(over.c2, over.c3)));
  }
  return {jacobian, depth};
}

}  // namespace seiche::dispersive_shallow_water_2d
