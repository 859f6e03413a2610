/// The bilinear surface over a quadrilateral seen from above: the volume below it, its potential energy, and their
/// gradients with respect to the corners.
///
/// Corners 0..3 go around anticlockwise; a+1, a-1, a+2 are taken modulo 4. With the corner Jacobians
///
///     J_a = (x_{a+1} - x_a)(y_{a-1} - y_a) - (y_{a+1} - y_a)(x_{a-1} - x_a),   J_0 + J_2 = J_1 + J_3 = 2 area
///
///     volume   int z dA     = (1/12) sum_a J_a (z_{a-1} + z_a + z_{a+1})
///     moment   int z^2/2 dA = (1/2) sum_a J_a Q_a,
///     Q_a = [9 z_a^2 + 6 z_a (z_{a+1} + z_{a-1}) + 2 z_a z_{a+2} + 3 (z_{a+1}^2 + z_{a-1}^2) + z_{a+2}^2
///            + 2 z_{a+1} z_{a-1} + 2 (z_{a+1} + z_{a-1}) z_{a+2}]/144
///
/// The volume is at the same time the mean over the two ways to cut the quadrilateral into triangles: the patch prefers
/// no diagonal, and neighbouring patches meet. Both are polynomials, of degree 3 and 4 along any straight motion of the
/// corners: Simpson's mean of their gradients is an exact discrete gradient.
///
/// Everything is inline and without branches, for use in vectorised loops.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "seiche/simd_clones.hpp"

namespace seiche::bilinear_patch {

/// One number for each corner.
struct Corners {
  double c0, c1, c2, c3;
};

/// Of values of many nodes, those at four of them.
inline Corners at_corners(std::span<const double> values, const std::array<std::size_t, 4>& nodes) {
  return {values[nodes[0]], values[nodes[1]], values[nodes[2]], values[nodes[3]]};
}
/// At patch i between two rows of nodes.
SEICHE_INLINE Corners corners_between(const std::array<const double*, 2>& rows, std::size_t i) {
  return {rows[0][i], rows[0][i + 1], rows[1][i + 1], rows[1][i]};
}
/// Not a number where one is not.
inline double smallest(const Corners& c) {
  return std::min(std::min(c.c0, c.c1), std::min(c.c2, c.c3));
}

/// Between the corners, with s from 0 to 1 from the first to the second and t from the first to the last.
inline double mix(const Corners& c, double s, double t) {
  return (1 - t) * ((1 - s) * c.c0 + s * c.c1) + t * ((1 - s) * c.c3 + s * c.c2);
}
inline double along_s(const Corners& c, double t) {
  return (1 - t) * (c.c1 - c.c0) + t * (c.c2 - c.c3);
}
inline double along_t(const Corners& c, double s) {
  return (1 - s) * (c.c3 - c.c0) + s * (c.c2 - c.c1);
}

/// A plane vector for each corner.
struct CornerVectors {
  Corners x, y, z;
};

SEICHE_INLINE Corners jacobians(const Corners& x, const Corners& y) {
  const double j0 = (x.c1 - x.c0) * (y.c3 - y.c0) - (y.c1 - y.c0) * (x.c3 - x.c0);
  const double j1 = (x.c2 - x.c1) * (y.c0 - y.c1) - (y.c2 - y.c1) * (x.c0 - x.c1);
  const double j2 = (x.c3 - x.c2) * (y.c1 - y.c2) - (y.c3 - y.c2) * (x.c1 - x.c2);
  const double j3 = (x.c0 - x.c3) * (y.c2 - y.c3) - (y.c0 - y.c3) * (x.c2 - x.c3);
  return {j0, j1, j2, j3};
}

/// z_{a-1} + z_a + z_{a+1}.
SEICHE_INLINE Corners threes(const Corners& z) {
  const double all = z.c0 + z.c1 + z.c2 + z.c3;
  return {all - z.c2, all - z.c3, all - z.c0, all - z.c1};
}

SEICHE_INLINE Corners quadratics(const Corners& z) {
  const auto one = [](double a, double next, double before, double opposite) {
    const double sides = next + before;
    return (a * (9 * a + 6 * sides + 2 * opposite) + 3 * sides * sides - 4 * next * before +
            opposite * (opposite + 2 * sides)) /
           144;
  };
  return {one(z.c0, z.c1, z.c3, z.c2), one(z.c1, z.c2, z.c0, z.c3), one(z.c2, z.c3, z.c1, z.c0),
          one(z.c3, z.c0, z.c2, z.c1)};
}

/// sum_b (dJ_b/dx_a) s_b for every corner a, from the y of the corners; with y replaced by -x: the same along y.
SEICHE_INLINE Corners along(const Corners& y, const Corners& s) {
  return {s.c0 * (y.c1 - y.c3) + s.c3 * (y.c2 - y.c3) + s.c1 * (y.c1 - y.c2),
          s.c1 * (y.c2 - y.c0) + s.c0 * (y.c3 - y.c0) + s.c2 * (y.c2 - y.c3),
          s.c2 * (y.c3 - y.c1) + s.c1 * (y.c0 - y.c1) + s.c3 * (y.c3 - y.c0),
          s.c3 * (y.c0 - y.c2) + s.c2 * (y.c1 - y.c2) + s.c0 * (y.c0 - y.c1)};
}

SEICHE_INLINE Corners scaled(double factor, const Corners& s) {
  return {factor * s.c0, factor * s.c1, factor * s.c2, factor * s.c3};
}

SEICHE_INLINE double dot(const Corners& a, const Corners& b) {
  return a.c0 * b.c0 + a.c1 * b.c1 + a.c2 * b.c2 + a.c3 * b.c3;
}

SEICHE_INLINE double volume(const Corners& x, const Corners& y, const Corners& z) {
  return dot(jacobians(x, y), threes(z)) / 12;
}

SEICHE_INLINE double moment(const Corners& x, const Corners& y, const Corners& z) {
  return dot(jacobians(x, y), quadratics(z)) / 2;
}

SEICHE_INLINE CornerVectors volume_gradient(const Corners& x, const Corners& y, const Corners& z,
                                            const Corners& jacobian) {
  const Corners s = threes(z);
  return {scaled(1.0 / 12, along(y, s)), scaled(-1.0 / 12, along(x, s)), scaled(1.0 / 12, threes(jacobian))};
}

SEICHE_INLINE CornerVectors moment_gradient(const Corners& x, const Corners& y, const Corners& z,
                                            const Corners& jacobian) {
  const Corners q = quadratics(z);
  const double sum = z.c0 + z.c1 + z.c2 + z.c3;
  // d Q_a/dz_a, d Q_{a+1}/dz_a and d Q_{a-1}/dz_a, d Q_{a+2}/dz_a, times 144.
  const auto one = [&](double j, double j_next, double j_before, double j_opposite, double a, double next,
                       double before, double opposite) {
    const double sides = next + before;
    return (j * (18 * a + 6 * sides + 2 * opposite) + j_next * (6 * (a + next) + 2 * (opposite + before)) +
            j_before * (6 * (a + before) + 2 * (opposite + next)) + 2 * j_opposite * sum) /
           288;
  };
  const Corners& j = jacobian;
  return {scaled(0.5, along(y, q)),
          scaled(-0.5, along(x, q)),
          {one(j.c0, j.c1, j.c3, j.c2, z.c0, z.c1, z.c3, z.c2), one(j.c1, j.c2, j.c0, j.c3, z.c1, z.c2, z.c0, z.c3),
           one(j.c2, j.c3, j.c1, j.c0, z.c2, z.c3, z.c1, z.c0), one(j.c3, j.c0, j.c2, j.c1, z.c3, z.c0, z.c2, z.c1)}};
}

}  // namespace seiche::bilinear_patch
