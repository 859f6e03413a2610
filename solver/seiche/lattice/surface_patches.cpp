#include "seiche/lattice/surface_patches.hpp"

#include <array>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::lattice {

namespace {

using bilinear_patch::Corners;

/// Nodes south and north of a row of patches, by axis.
using PatchRows = std::array<std::array<const double*, 2>, 3>;

PatchRows rows_from(const double* first, std::size_t nodes, std::size_t stride) {
  PatchRows rows;
  for (std::size_t axis = 0; axis < 3; ++axis) rows[axis] = {first + axis * nodes, first + axis * nodes + stride};
  return rows;
}

SEICHE_SIMD_CLONES
void press_patches(std::size_t columns, const PatchRows& rows, double weight, linear::RowBlocks::Row forces) {
  const PatchRows r = rows;
  double* const out = forces.data;
  const std::size_t stride = forces.stride;
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    const Corners x = bilinear_patch::corners_between(r[0], i);
    const Corners y = bilinear_patch::corners_between(r[1], i);
    const Corners z = bilinear_patch::corners_between(r[2], i);
    const auto g = bilinear_patch::moment_gradient(x, y, z, bilinear_patch::jacobians(x, y));
    const auto put = [&](std::size_t axis, const Corners& along) __attribute__((always_inline)) {
      out[axis * stride + i] = -weight * along.c0;
      out[(3 + axis) * stride + i] = -weight * along.c1;
      out[(6 + axis) * stride + i] = -weight * along.c2;
      out[(9 + axis) * stride + i] = -weight * along.c3;
    };
    put(0, g.x);
    put(1, g.y);
    put(2, g.z);
  }
}

/// push += the forces of the rows of patches south and north of a row of columns + 1 nodes.
SEICHE_SIMD_CLONES
void gather_push(std::size_t columns, linear::RowBlocks::ConstRow south, linear::RowBlocks::ConstRow north,
                 const std::array<double*, 3>& push) {
  const auto last = static_cast<std::ptrdiff_t>(columns);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* const se = south[9 + axis];
    const double* const sw = south[6 + axis];
    const double* const ne = north[axis];
    const double* const nw = north[3 + axis];
    double* __restrict out = push[axis];
#pragma omp simd
    for (std::ptrdiff_t i = 0; i <= last; ++i) out[i] += (se[i] + sw[i - 1]) + (ne[i] + nw[i - 1]);
  }
}

}  // namespace

void SurfacePatches::push(mechanics::Input q, double weight, mechanics::Output push) {
  const bool worth_it = nodes_ > linear::worth_threads;
  const std::size_t stride = columns_ + 1;
  const linear::RowBlocks& forces = forces_;
  linear::share_out(rows_, worth_it, [&](std::size_t j) {
    press_patches(columns_, rows_from(q.data() + first_ + j * stride, nodes_, stride), weight, forces_.row(j));
  });
  linear::share_out(rows_ + 1, worth_it, [&](std::size_t j) {
    double* const out = push.data() + first_ + j * stride;
    gather_push(columns_, j > 0 ? forces.row(j - 1) : forces.zeros(), j < rows_ ? forces.row(j) : forces.zeros(),
                {out, out + nodes_, out + 2 * nodes_});
  });
}

double SurfacePatches::moment(mechanics::Input q, std::span<const char> counted) const {
  CompensatedSum sum;
  for (std::size_t cell = 0; cell < columns_ * rows_; ++cell) {
    if (!counted.empty() && counted[cell] == 0) continue;
    const std::size_t stride = columns_ + 1;
    const PatchRows r = rows_from(q.data() + first_ + cell / columns_ * stride, nodes_, stride);
    const auto along = [&](std::size_t axis) { return bilinear_patch::corners_between(r[axis], cell % columns_); };
    sum.add(bilinear_patch::moment(along(0), along(1), along(2)));
  }
  return sum.value();
}

}  // namespace seiche::lattice
