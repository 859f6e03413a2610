#include "seiche/models/lagrangian_mesh_3d/surface.hpp"

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

using bilinear_patch::Corners;

inline Corners corners(const PatchRows& r, std::size_t axis, std::size_t i) {
  return {r.south[axis][i], r.south[axis][i + 1], r.north[axis][i + 1], r.north[axis][i]};
}

}  // namespace

SEICHE_SIMD_CLONES
void press_patches(std::size_t columns, const PatchRows& rows, double weight, linear::RowBlocks::Row forces) {
  const PatchRows r = rows;
  double* const out = forces.data;
  const std::size_t stride = forces.stride;
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    const Corners x = corners(r, 0, i);
    const Corners y = corners(r, 1, i);
    const Corners z = corners(r, 2, i);
    const auto g = bilinear_patch::moment_gradient(x, y, z, bilinear_patch::jacobians(x, y));
    out[i] = -weight * g.x.c0;
    out[stride + i] = -weight * g.y.c0;
    out[2 * stride + i] = -weight * g.z.c0;
    out[3 * stride + i] = -weight * g.x.c1;
    out[4 * stride + i] = -weight * g.y.c1;
    out[5 * stride + i] = -weight * g.z.c1;
    out[6 * stride + i] = -weight * g.x.c2;
    out[7 * stride + i] = -weight * g.y.c2;
    out[8 * stride + i] = -weight * g.z.c2;
    out[9 * stride + i] = -weight * g.x.c3;
    out[10 * stride + i] = -weight * g.y.c3;
    out[11 * stride + i] = -weight * g.z.c3;
  }
}

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

double moment_of_row(std::size_t columns, const PatchRows& r) {
  double sum = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    sum += bilinear_patch::moment(corners(r, 0, i), corners(r, 1, i), corners(r, 2, i));
  }
  return sum;
}

}  // namespace seiche::lagrangian_mesh_3d
