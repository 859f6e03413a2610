#include "seiche/models/dispersive_shallow_water_2d/rows.hpp"

#include <algorithm>
#include <limits>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// Pointers to a row of one corner's gradient.
struct GradientRow {
  const double* x;
  const double* y;
  const double* z;
};

SEICHE_INLINE GradientRow row_of(const CellGradients& gradients, std::size_t corner, std::ptrdiff_t first) {
  return {gradients.x[corner].data() + first, gradients.y[corner].data() + first, gradients.z[corner].data() + first};
}

struct MassRow {
  const double* xx;
  const double* yy;
  const double* zz;
  const double* xy;
  const double* xz;
  const double* yz;
};

SEICHE_INLINE MassRow row_of(const InverseMasses& w, std::size_t node) {
  return {w.xx.data() + node, w.yy.data() + node, w.zz.data() + node,
          w.xy.data() + node, w.xz.data() + node, w.yz.data() + node};
}

/// a . W b of cell i of row a and cell k of row b at node n of row w.
template <bool full>
SEICHE_INLINE double form(const GradientRow& a, std::size_t i, const MassRow& w, std::size_t n, const GradientRow& b,
                          std::size_t k) {
  double sum = a.x[i] * w.xx[n] * b.x[k] + a.y[i] * w.yy[n] * b.y[k] + a.z[i] * w.zz[n] * b.z[k];
  if constexpr (full) {
    sum += w.xy[n] * (a.x[i] * b.y[k] + a.y[i] * b.x[k]) + w.xz[n] * (a.x[i] * b.z[k] + a.z[i] * b.x[k]) +
           w.yz[n] * (a.y[i] * b.z[k] + a.z[i] * b.y[k]);
  }
  return sum;
}

template <bool full>
SEICHE_INLINE void push(const MassRow& w, std::size_t n, double fx, double fy, double fz, double* u, double* v,
                        double* r) {
  if constexpr (full) {
    u[n] += w.xx[n] * fx + w.xy[n] * fy + w.xz[n] * fz;
    v[n] += w.xy[n] * fx + w.yy[n] * fy + w.yz[n] * fz;
    r[n] += w.xz[n] * fx + w.yz[n] * fy + w.zz[n] * fz;
  } else {
    u[n] += w.xx[n] * fx;
    v[n] += w.yy[n] * fy;
    r[n] += w.zz[n] * fz;
  }
}

template <bool full>
SEICHE_INLINE void assemble(std::size_t columns, std::size_t first, std::size_t lower, bool has_row_above,
                            const CellGradients& gradients, const InverseMasses& masses,
                            linear::NinePointMatrix& matrix) {
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const auto next = begin + static_cast<std::ptrdiff_t>(columns);
  const GradientRow g0 = row_of(gradients, 0, begin);
  const GradientRow g1 = row_of(gradients, 1, begin);
  const GradientRow g2 = row_of(gradients, 2, begin);
  const GradientRow g3 = row_of(gradients, 3, begin);
  const MassRow wl = row_of(masses, lower);
  const MassRow wu = row_of(masses, lower + columns + 1);
  double* const own = matrix.own.data() + first;
  double* const right = matrix.right.data() + first;
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    own[i] = (form<full>(g0, i, wl, i, g0, i) + form<full>(g1, i, wl, i + 1, g1, i)) +
             (form<full>(g3, i, wu, i, g3, i) + form<full>(g2, i, wu, i + 1, g2, i));
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    right[i] = form<full>(g1, i, wl, i + 1, g0, i + 1) + form<full>(g2, i, wu, i + 1, g3, i + 1);
  }
  if (!has_row_above) return;
  const GradientRow a0 = row_of(gradients, 0, next);
  const GradientRow a1 = row_of(gradients, 1, next);
  double* const up = matrix.up.data() + first;
  double* const up_right = matrix.up_right.data() + first;
  double* const up_left = matrix.up_left.data() + first;
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    up[i] = form<full>(g3, i, wu, i, a0, i) + form<full>(g2, i, wu, i + 1, a1, i);
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i + 1 < columns; ++i) up_right[i] = form<full>(g2, i, wu, i + 1, a0, i + 1);
#pragma GCC ivdep
  for (std::size_t i = 1; i < columns; ++i) up_left[i] = form<full>(g3, i, wu, i, a1, i - 1);
}

template <bool full>
SEICHE_INLINE void react(std::size_t columns, std::size_t node, std::ptrdiff_t below, std::ptrdiff_t above,
                         const CellGradients& gradients, const double* mu_below, const double* mu_above,
                         const InverseMasses& masses, const std::array<double*, 3>& velocity) {
  const GradientRow a0 = row_of(gradients, 0, above);
  const GradientRow a1 = row_of(gradients, 1, above);
  const GradientRow b2 = row_of(gradients, 2, below);
  const GradientRow b3 = row_of(gradients, 3, below);
  const MassRow w = row_of(masses, node);
  double* const u = velocity[0];
  double* const v = velocity[1];
  double* const r = velocity[2];
  const double* const ma = mu_above;
  const double* const mb = mu_below;
  const std::size_t n = columns;
  push<full>(w, 0, ma[0] * a0.x[0] + mb[0] * b3.x[0], ma[0] * a0.y[0] + mb[0] * b3.y[0],
             ma[0] * a0.z[0] + mb[0] * b3.z[0], u, v, r);
#pragma GCC ivdep
  for (std::size_t i = 1; i < n; ++i) {
    const double fx = (ma[i] * a0.x[i] + ma[i - 1] * a1.x[i - 1]) + (mb[i] * b3.x[i] + mb[i - 1] * b2.x[i - 1]);
    const double fy = (ma[i] * a0.y[i] + ma[i - 1] * a1.y[i - 1]) + (mb[i] * b3.y[i] + mb[i - 1] * b2.y[i - 1]);
    const double fz = (ma[i] * a0.z[i] + ma[i - 1] * a1.z[i - 1]) + (mb[i] * b3.z[i] + mb[i - 1] * b2.z[i - 1]);
    push<full>(w, i, fx, fy, fz, u, v, r);
  }
  push<full>(w, n, ma[n - 1] * a1.x[n - 1] + mb[n - 1] * b2.x[n - 1], ma[n - 1] * a1.y[n - 1] + mb[n - 1] * b2.y[n - 1],
             ma[n - 1] * a1.z[n - 1] + mb[n - 1] * b2.z[n - 1], u, v, r);
}

template <bool full>
SEICHE_INLINE void kick(std::size_t count, std::size_t node, double h, const std::array<const double*, 3>& force,
                        const InverseMasses& masses, const std::array<double*, 3>& velocity) {
  const MassRow w = row_of(masses, node);
  const double* const fx = force[0];
  const double* const fy = force[1];
  const double* const fz = force[2];
  double* const u = velocity[0];
  double* const v = velocity[1];
  double* const r = velocity[2];
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) push<full>(w, i, h * fx[i], h * fy[i], h * fz[i], u, v, r);
}

}  // namespace

SEICHE_SIMD_CLONES
RowExtremes measure_row(std::size_t columns, std::size_t first, const PlaceRows& at, double bottom, double gravity,
                        double weight, bool add, CellGradients& gradients, const std::array<ForceRows, 3>& forces,
                        double* scratch) {
  using bilinear_patch::Corners;
  const double* const xl = at.x.lower;
  const double* const xu = at.x.upper;
  const double* const yl = at.y.lower;
  const double* const yu = at.y.upper;
  const double* const zl = at.z.lower;
  const double* const zu = at.z.upper;
  std::array<double*, 12> g{};
  std::array<double*, 12> f{};
  for (std::size_t c = 0; c < 4; ++c) {
    g[c] = gradients.x[c].data() + first;
    g[4 + c] = gradients.y[c].data() + first;
    g[8 + c] = gradients.z[c].data() + first;
  }
  for (std::size_t c = 0; c < 12; ++c) f[c] = scratch + c * columns;
  const double pull = -gravity * weight;
  double jacobian = std::numeric_limits<double>::infinity();
  double depth = std::numeric_limits<double>::infinity();
  if (!add) {
    for (double* row : g) std::fill(row, row + columns, 0.0);
  }
#pragma omp simd reduction(min : jacobian, depth)
  for (std::size_t i = 0; i < columns; ++i) {
    const Corners x{xl[i], xl[i + 1], xu[i + 1], xu[i]};
    const Corners y{yl[i], yl[i + 1], yu[i + 1], yu[i]};
    const Corners z{zl[i], zl[i + 1], zu[i + 1], zu[i]};
    const Corners over{z.c0 - bottom, z.c1 - bottom, z.c2 - bottom, z.c3 - bottom};
    const Corners j = bilinear_patch::jacobians(x, y);
    const auto volume = bilinear_patch::volume_gradient(x, y, over, j);
    const auto moment = bilinear_patch::moment_gradient(x, y, z, j);
    g[0][i] += weight * volume.x.c0;
    g[1][i] += weight * volume.x.c1;
    g[2][i] += weight * volume.x.c2;
    g[3][i] += weight * volume.x.c3;
    g[4][i] += weight * volume.y.c0;
    g[5][i] += weight * volume.y.c1;
    g[6][i] += weight * volume.y.c2;
    g[7][i] += weight * volume.y.c3;
    g[8][i] += weight * volume.z.c0;
    g[9][i] += weight * volume.z.c1;
    g[10][i] += weight * volume.z.c2;
    g[11][i] += weight * volume.z.c3;
    f[0][i] = pull * moment.x.c0;
    f[1][i] = pull * moment.x.c1;
    f[2][i] = pull * moment.x.c2;
    f[3][i] = pull * moment.x.c3;
    f[4][i] = pull * moment.y.c0;
    f[5][i] = pull * moment.y.c1;
    f[6][i] = pull * moment.y.c2;
    f[7][i] = pull * moment.y.c3;
    f[8][i] = pull * moment.z.c0;
    f[9][i] = pull * moment.z.c1;
    f[10][i] = pull * moment.z.c2;
    f[11][i] = pull * moment.z.c3;
    jacobian = std::min(jacobian, std::min(std::min(j.c0, j.c1), std::min(j.c2, j.c3)));
    depth = std::min(depth, std::min(std::min(over.c0, over.c1), std::min(over.c2, over.c3)));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* const f0 = f[4 * axis];
    const double* const f1 = f[4 * axis + 1];
    const double* const f2 = f[4 * axis + 2];
    const double* const f3 = f[4 * axis + 3];
    double* const lower = forces[axis].lower;
    double* const upper = forces[axis].upper;
    lower[0] += f0[0];
    upper[0] += f3[0];
#pragma GCC ivdep
    for (std::size_t i = 1; i < columns; ++i) {
      lower[i] += f0[i] + f1[i - 1];
      upper[i] += f3[i] + f2[i - 1];
    }
    lower[columns] += f1[columns - 1];
    upper[columns] += f2[columns - 1];
  }
  return {jacobian, depth};
}

SEICHE_SIMD_CLONES
void rates_of_row(std::size_t columns, std::size_t first, const CellGradients& gradients,
                  const std::array<NodeRows, 3>& velocity, double* rates) {
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const GradientRow g0 = row_of(gradients, 0, begin);
  const GradientRow g1 = row_of(gradients, 1, begin);
  const GradientRow g2 = row_of(gradients, 2, begin);
  const GradientRow g3 = row_of(gradients, 3, begin);
  const auto [ul, uu] = velocity[0];
  const auto [vl, vu] = velocity[1];
  const auto [rl, ru] = velocity[2];
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    rates[i] = (g0.x[i] * ul[i] + g0.y[i] * vl[i] + g0.z[i] * rl[i]) +
               (g1.x[i] * ul[i + 1] + g1.y[i] * vl[i + 1] + g1.z[i] * rl[i + 1]) +
               (g2.x[i] * uu[i + 1] + g2.y[i] * vu[i + 1] + g2.z[i] * ru[i + 1]) +
               (g3.x[i] * uu[i] + g3.y[i] * vu[i] + g3.z[i] * ru[i]);
  }
}

SEICHE_SIMD_CLONES
void assemble_row(std::size_t columns, std::size_t first, std::size_t lower, bool full, bool has_row_above,
                  const CellGradients& gradients, const InverseMasses& w, linear::NinePointMatrix& matrix) {
  if (full) {
    assemble<true>(columns, first, lower, has_row_above, gradients, w, matrix);
  } else {
    assemble<false>(columns, first, lower, has_row_above, gradients, w, matrix);
  }
}

SEICHE_SIMD_CLONES
void react_row(std::size_t columns, std::size_t node, bool full, std::ptrdiff_t below, std::ptrdiff_t above,
               const CellGradients& gradients, const double* mu_below, const double* mu_above, const InverseMasses& w,
               const std::array<double*, 3>& velocity) {
  if (full) {
    react<true>(columns, node, below, above, gradients, mu_below, mu_above, w, velocity);
  } else {
    react<false>(columns, node, below, above, gradients, mu_below, mu_above, w, velocity);
  }
}

SEICHE_SIMD_CLONES
void kick_row(std::size_t count, std::size_t node, bool full, double h, const std::array<const double*, 3>& force,
              const InverseMasses& w, const std::array<double*, 3>& velocity) {
  if (full) {
    kick<true>(count, node, h, force, w, velocity);
  } else {
    kick<false>(count, node, h, force, w, velocity);
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
