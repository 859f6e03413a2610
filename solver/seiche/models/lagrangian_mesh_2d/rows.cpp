#include "seiche/models/lagrangian_mesh_2d/rows.hpp"

#include <algorithm>
#include <limits>

#include "seiche/simd_clones.hpp"

namespace seiche::lagrangian_mesh_2d {

SEICHE_SIMD_CLONES
double measure_row(std::size_t columns, std::size_t first, NodeRows x, NodeRows y, Diagonals& diagonals) {
  const double* __restrict xl = x.lower;
  const double* __restrict xu = x.upper;
  const double* __restrict yl = y.lower;
  const double* __restrict yu = y.upper;
  double* __restrict ax = diagonals.ax.data() + first;
  double* __restrict ay = diagonals.ay.data() + first;
  double* __restrict bx = diagonals.bx.data() + first;
  double* __restrict by = diagonals.by.data() + first;
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

SEICHE_SIMD_CLONES
void rates_of_row(std::size_t columns, std::size_t first, const Diagonals& diagonals, NodeRows u, NodeRows v,
                  double* rates) {
  const double* __restrict ul = u.lower;
  const double* __restrict uu = u.upper;
  const double* __restrict vl = v.lower;
  const double* __restrict vu = v.upper;
  const double* __restrict ax = diagonals.ax.data() + first;
  const double* __restrict ay = diagonals.ay.data() + first;
  const double* __restrict bx = diagonals.bx.data() + first;
  const double* __restrict by = diagonals.by.data() + first;
  double* __restrict w = rates;
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    w[i] = bx[i] * (vl[i] - vu[i + 1]) - by[i] * (ul[i] - uu[i + 1]) + ay[i] * (ul[i + 1] - uu[i]) -
           ax[i] * (vl[i + 1] - vu[i]);
  }
}

SEICHE_SIMD_CLONES
void assemble_row(std::size_t columns, std::size_t first, bool has_row_above, const Diagonals& diagonals, NodeRows wx,
                  NodeRows wy, linear::NinePointMatrix& matrix) {
  const double* __restrict wxl = wx.lower;
  const double* __restrict wxu = wx.upper;
  const double* __restrict wyl = wy.lower;
  const double* __restrict wyu = wy.upper;
  const double* __restrict ax = diagonals.ax.data() + first;
  const double* __restrict ay = diagonals.ay.data() + first;
  const double* __restrict bx = diagonals.bx.data() + first;
  const double* __restrict by = diagonals.by.data() + first;
  double* __restrict own = matrix.own.data() + first;
  double* __restrict right = matrix.right.data() + first;
  // Gradients g0 = (-by, bx) at r0 and -g0 at r2, g1 = (ay, -ax) at r1 and -g1 at r3; shared nodes couple cells.
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    own[i] = by[i] * by[i] * (wxl[i] + wxu[i + 1]) + bx[i] * bx[i] * (wyl[i] + wyu[i + 1]) +
             ay[i] * ay[i] * (wxl[i + 1] + wxu[i]) + ax[i] * ax[i] * (wyl[i + 1] + wyu[i]);
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    right[i] = -(ay[i] * by[i + 1] * wxl[i + 1] + ax[i] * bx[i + 1] * wyl[i + 1]) -
               (by[i] * ay[i + 1] * wxu[i + 1] + bx[i] * ax[i + 1] * wyu[i + 1]);
  }
  if (!has_row_above) return;
  const double* __restrict axa = ax + columns;
  const double* __restrict aya = ay + columns;
  const double* __restrict bxa = bx + columns;
  const double* __restrict bya = by + columns;
  double* __restrict up = matrix.up.data() + first;
  double* __restrict up_right = matrix.up_right.data() + first;
  double* __restrict up_left = matrix.up_left.data() + first;
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    up[i] = (ay[i] * bya[i] * wxu[i] + ax[i] * bxa[i] * wyu[i]) +
            (by[i] * aya[i] * wxu[i + 1] + bx[i] * axa[i] * wyu[i + 1]);
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    up_right[i] = -(by[i] * bya[i + 1] * wxu[i + 1] + bx[i] * bxa[i + 1] * wyu[i + 1]);
  }
#pragma GCC ivdep
  for (std::size_t i = 1; i < columns; ++i) {
    up_left[i] = -(ay[i] * aya[i - 1] * wxu[i] + ax[i] * axa[i - 1] * wyu[i]);
  }
}

SEICHE_SIMD_CLONES
void react_row(std::size_t columns, std::ptrdiff_t below, std::ptrdiff_t above, const Diagonals& diagonals,
               const double* mu_below, const double* mu_above, const double* wx, const double* wy, double* u,
               double* v) {
  const double* __restrict axb = diagonals.ax.data() + below;
  const double* __restrict ayb = diagonals.ay.data() + below;
  const double* __restrict bxb = diagonals.bx.data() + below;
  const double* __restrict byb = diagonals.by.data() + below;
  const double* __restrict axa = diagonals.ax.data() + above;
  const double* __restrict aya = diagonals.ay.data() + above;
  const double* __restrict bxa = diagonals.bx.data() + above;
  const double* __restrict bya = diagonals.by.data() + above;
  const double* __restrict mb = mu_below;
  const double* __restrict ma = mu_above;
  double* __restrict ur = u;
  double* __restrict vr = v;
  const std::size_t n = columns;
  ur[0] -= wx[0] * (ma[0] * bya[0] + mb[0] * ayb[0]);
  vr[0] += wy[0] * (ma[0] * bxa[0] + mb[0] * axb[0]);
#pragma GCC ivdep
  for (std::size_t i = 1; i < n; ++i) {
    ur[i] += wx[i] * (ma[i - 1] * aya[i - 1] - ma[i] * bya[i] + mb[i - 1] * byb[i - 1] - mb[i] * ayb[i]);
    vr[i] += wy[i] * (ma[i] * bxa[i] - ma[i - 1] * axa[i - 1] + mb[i] * axb[i] - mb[i - 1] * bxb[i - 1]);
  }
  ur[n] += wx[n] * (ma[n - 1] * aya[n - 1] + mb[n - 1] * byb[n - 1]);
  vr[n] -= wy[n] * (ma[n - 1] * axa[n - 1] + mb[n - 1] * bxb[n - 1]);
}

}  // namespace seiche::lagrangian_mesh_2d
