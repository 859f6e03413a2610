#include "seiche/models/lagrangian_mesh_2d/element.hpp"

#include <algorithm>
#include <limits>

namespace seiche::lagrangian_mesh_2d {

SEICHE_SIMD_CLONES
void Quadrilateral::assemble_row(const lattice::Assembly<Quadrilateral>& row) {
  lattice::assemble<Quadrilateral, false>(row);
}

SEICHE_SIMD_CLONES
void Quadrilateral::rates_of_row(const lattice::Rates<Quadrilateral>& row) {
  lattice::find_rates(row);
}

SEICHE_SIMD_CLONES
void Quadrilateral::react_row(const lattice::Reaction<Quadrilateral>& row) {
  lattice::react<Quadrilateral, false>(row);
}

SEICHE_SIMD_CLONES
void Quadrilateral::kick_row(const lattice::Kick<Quadrilateral>& row) {
  lattice::kick<Quadrilateral, false>(row);
}

SEICHE_SIMD_CLONES
double measure_row(std::size_t columns, const lattice::NodeVectors<Quadrilateral>& r,
                   linear::RowBlocks::Row diagonals) {
  const double* __restrict xl = r[0][0];
  const double* __restrict xu = r[0][1];
  const double* __restrict yl = r[1][0];
  const double* __restrict yu = r[1][1];
  double* __restrict ax = diagonals[0];
  double* __restrict ay = diagonals[1];
  double* __restrict bx = diagonals[2];
  double* __restrict by = diagonals[3];
  double worst = std::numeric_limits<double>::infinity();
#pragma omp simd reduction(min : worst)
  for (std::size_t i = 0; i < columns; ++i) {
    ax[i] = 0.5 * (xu[i + 1] - xl[i]);
    ay[i] = 0.5 * (yu[i + 1] - yl[i]);
    bx[i] = 0.5 * (xu[i] - xl[i + 1]);
    by[i] = 0.5 * (yu[i] - yl[i + 1]);
    // Opposite triangles add up to the whole cell.
    const double twice_area = 4 * (ax[i] * by[i] - bx[i] * ay[i]);
    const double bottom_x = xl[i + 1] - xl[i];
    const double bottom_y = yl[i + 1] - yl[i];
    const double at0 = bottom_x * (yu[i] - yl[i]) - bottom_y * (xu[i] - xl[i]);
    const double at1 = bottom_x * (yu[i + 1] - yl[i + 1]) - bottom_y * (xu[i + 1] - xl[i + 1]);
    worst = std::min(worst, std::min(std::min(at0, at1), twice_area - std::max(at0, at1)));
  }
  return worst;
}

}  // namespace seiche::lagrangian_mesh_2d
