#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/geometry/vector.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

double determinant(const Vector& a, const Vector& b, const Vector& c) {
  return dot(a, cross(b, c));
}

/// Of the depth: how far a node may be off the bottom that it slides on.
constexpr double on_bottom = 1e-12;

/// Neighbours of a corner along the edges that leave it, in right-handed order.
constexpr std::array<std::array<std::size_t, 3>, 8> edges{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

using V3 = Vector3;

SEICHE_INLINE V3 at(const NodeVectors& r, std::size_t corner, std::size_t i) {
  const auto [east, north, above] = lattice::place_of[corner];
  const auto row = static_cast<std::size_t>(north + 2 * above);
  const std::size_t k = i + static_cast<std::size_t>(east);
  return {r[0][row][k], r[1][row][k], r[2][row][k]};
}

}  // namespace

SEICHE_SIMD_CLONES
void measure_row(std::size_t columns, const NodeVectors& rows, double factor, bool add, RowBlocks::Row gradients) {
  const NodeVectors r = rows;
  double* const out = gradients.data;
  const std::size_t stride = gradients.stride;
  if (!add) {
    for (std::size_t k = 0; k < Hexahedron::stored; ++k) std::fill_n(gradients[k], columns, 0.0);
  }
#pragma GCC ivdep
  for (std::size_t i = 0; i < columns; ++i) {
    // Sums and differences along x on the four edges (0,1), (3,2), (4,5), (7,6).
    const V3 r0 = at(r, 0, i), r1 = at(r, 1, i), r2 = at(r, 2, i), r3 = at(r, 3, i);
    const V3 r4 = at(r, 4, i), r5 = at(r, 5, i), r6 = at(r, 6, i), r7 = at(r, 7, i);
    const V3 t0 = r1 - r0, t1 = r2 - r3, t2 = r5 - r4, t3 = r6 - r7;
    // Sums first by differences along y and z: they cancel what is common to all corners.
    const V3 north_low = (r3 - r0) + (r2 - r1);
    const V3 north_high = (r7 - r4) + (r6 - r5);
    const V3 up_south = (r4 - r0) + (r5 - r1);
    const V3 up_north = (r7 - r3) + (r6 - r2);
    const V3 a = (t0 + t1) + (t2 + t3);
    const V3 e = (t2 + t3) - (t0 + t1);
    const V3 f = (t1 - t0) + (t3 - t2);
    const V3 b = north_low + north_high;
    const V3 c = up_south + up_north;
    const V3 d = north_high - north_low;
    // Modes are eight times those of the formula.
    const double third = factor / (3 * 64);
    const double whole = factor / 64;
    const V3 fa = whole * cross(b, c) + third * cross(f, e);
    const V3 fb = whole * cross(c, a) + third * cross(d, f);
    const V3 fc = whole * cross(a, b) + third * cross(e, d);
    const V3 fd = third * (cross(c, e) + cross(f, b));
    const V3 fe = third * (cross(d, c) + cross(a, f));
    const V3 ff = third * (cross(b, d) + cross(e, a));
    const V3 p = fa - fe, q = fb - fd, s = fa + fe, t = fb + fd;
    const V3 minus = ff - fc, plus = ff + fc;
    const auto put = [&](std::size_t corner, V3 g) __attribute__((always_inline)) {
      out[(3 * corner) * stride + i] += g.x;
      out[(3 * corner + 1) * stride + i] += g.y;
      out[(3 * corner + 2) * stride + i] += g.z;
    };
    put(0, minus - (p + q));
    put(1, (p - q) - plus);
    put(2, (p + q) + minus);
    put(3, (q - p) - plus);
    put(4, plus - (s + t));
    put(5, (s - t) - minus);
    put(6, (s + t) + plus);
    put(7, (t - s) - minus);
  }
}

std::array<std::size_t, 8> Mesh::corners(std::size_t cell) const {
  const std::size_t level = cell / plan.cells() * plan.nodes();
  const auto below = plan.corners(cell % plan.cells());
  std::array<std::size_t, 8> all{};
  for (std::size_t a = 0; a < 4; ++a) {
    all[a] = level + below[a];
    all[a + 4] = level + plan.nodes() + below[a];
  }
  return all;
}

void Mesh::require_valid() const {
  require_at_least("layers", static_cast<long>(layers), 1);
  plan_lattice::require_places(plan, 1, layers + 1, {{"x", x}, {"y", y}, {"z", z}});
  require_bottom();
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    const CellCorners r = corners_of(*this, x, y, z, cell);
    const auto volumes = corner_volumes(r);
    for (std::size_t a = 0; a < 8; ++a) {
      require_that(volumes[a] > 0,
                   "corner {} of cell {} at ({:g}, {:g}, {:g}) spans a volume of {:g}; allowed: positive", a, cell,
                   r[a].x, r[a].y, r[a].z, volumes[a]);
    }
  }
}

void Mesh::require_bottom() const {
  for (std::size_t k = 0; k < plan.nodes() && !free_bottom; ++k) {
    const double level = bottom ? bottom->slope(x[k], y[k]).elevation : z[0];
    const double allowed = bottom ? on_bottom * std::abs(level) : 0;
    require_that(std::abs(z[k] - level) <= allowed, "z = {:.17g} of bottom node {}; allowed: {}, {:.17g}", z[k], k,
                 bottom ? "the bottom's elevation" : "the others' elevation", level);
  }
  if (!bottom) return;
  require_that(!free_bottom, "a free bottom and an uneven one; allowed: one of them");
  require_that(!plan_lattice::any_side<plan_lattice::DrivenSide>(sides),
               "a driven side over an uneven bottom; allowed: walls, held and free sides");
}

double hexahedron_volume(const CellCorners& r) {
  // With modes a..f of xi, eta, zeta, eta zeta, zeta xi, xi eta: 8 [det(a,b,c) + (det(e,d,c) + det(f,b,d) +
  // det(a,f,e))/3]; the mode of xi eta zeta drops out.
  const auto mode = [&](const std::array<int, 8>& signs) {
    Vector sum;
    for (std::size_t k = 0; k < 8; ++k) sum = sum + signs[k] / 8.0 * (r[k] - r[0]);
    return sum;
  };
  const Vector a = mode({-1, 1, 1, -1, -1, 1, 1, -1});
  const Vector b = mode({-1, -1, 1, 1, -1, -1, 1, 1});
  const Vector c = mode({-1, -1, -1, -1, 1, 1, 1, 1});
  const Vector d = mode({1, 1, -1, -1, -1, -1, 1, 1});
  const Vector e = mode({1, -1, -1, 1, -1, 1, 1, -1});
  const Vector f = mode({1, -1, 1, -1, 1, -1, 1, -1});
  return 8 * (determinant(a, b, c) + (determinant(e, d, c) + determinant(f, b, d) + determinant(a, f, e)) / 3);
}

std::array<double, 8> corner_volumes(const CellCorners& r) {
  std::array<double, 8> volumes{};
  for (std::size_t a = 0; a < 8; ++a) {
    const auto [p, q, s] = edges[a];
    volumes[a] = determinant(r[p] - r[a], r[q] - r[a], r[s] - r[a]);
  }
  return volumes;
}

CellCorners corners_of(const Mesh& mesh, std::span<const double> x, std::span<const double> y,
                       std::span<const double> z, std::size_t cell) {
  CellCorners r;
  const auto nodes = mesh.corners(cell);
  for (std::size_t a = 0; a < 8; ++a) r[a] = {x[nodes[a]], y[nodes[a]], z[nodes[a]]};
  return r;
}

SEICHE_SIMD_CLONES
double inverted_corners_of_row(std::size_t columns, const NodeVectors& rows) {
  const NodeVectors r = rows;
  double tangled = 0;
#pragma omp simd reduction(+ : tangled)
  for (std::size_t i = 0; i < columns; ++i) {
    const V3 r0 = at(r, 0, i), r1 = at(r, 1, i), r2 = at(r, 2, i), r3 = at(r, 3, i);
    const V3 r4 = at(r, 4, i), r5 = at(r, 5, i), r6 = at(r, 6, i), r7 = at(r, 7, i);
    const V3 x0 = r1 - r0, x1 = r2 - r3, x2 = r5 - r4, x3 = r6 - r7;
    const V3 y0 = r3 - r0, y1 = r2 - r1, y2 = r7 - r4, y3 = r6 - r5;
    const V3 z0 = r4 - r0, z1 = r5 - r1, z2 = r6 - r2, z3 = r7 - r3;
    // Written so that a volume that is not a number counts.
    const double low = (dot(x0, cross(y0, z0)) > 0 ? 0.0 : 1.0) + (dot(x0, cross(y1, z1)) > 0 ? 0.0 : 1.0) +
                       (dot(x1, cross(y1, z2)) > 0 ? 0.0 : 1.0) + (dot(x1, cross(y0, z3)) > 0 ? 0.0 : 1.0);
    const double high = (dot(x2, cross(y2, z0)) > 0 ? 0.0 : 1.0) + (dot(x2, cross(y3, z1)) > 0 ? 0.0 : 1.0) +
                        (dot(x3, cross(y3, z2)) > 0 ? 0.0 : 1.0) + (dot(x3, cross(y2, z3)) > 0 ? 0.0 : 1.0);
    tangled += low + high;
  }
  return tangled;
}

SEICHE_SIMD_CLONES
void Hexahedron::run(const lattice::RowLoop<Hexahedron>& loop) {
  lattice::run_row(loop);
}

}  // namespace seiche::lagrangian_mesh_3d
