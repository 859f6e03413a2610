#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

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

}  // namespace

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
  require_at_least("columns", static_cast<long>(plan.columns), 1);
  require_at_least("rows", static_cast<long>(plan.rows), 1);
  require_at_least("layers", static_cast<long>(layers), 1);
  require_that(x.size() == nodes() && y.size() == nodes() && z.size() == nodes(),
               "coordinates of {}, {}, {} nodes; allowed: {} each", x.size(), y.size(), z.size(), nodes());
  for (std::size_t k = 0; k < nodes(); ++k) {
    require_that(std::isfinite(x[k]) || !std::isfinite(y[k]) || !std::isfinite(z[k]),
                 "node {} is at ({:g}, {:g}, {:g}); allowed: finite coordinates", k, x[k], y[k], z[k]);
  }
  require_bottom();
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    const CellCorners r = corners_of(*this, x, y, z, cell);
    const auto volumes = corner_volumes(r);
    for (std::size_t a = 0; a < 8; ++a) {
      if (volumes[a] > 0) continue;
      throw std::invalid_argument(
          fmt::format("corner {} of cell {} at ({:g}, {:g}, {:g}) spans a volume of {:g}; allowed: positive", a, cell,
                      r[a].x, r[a].y, r[a].z, volumes[a]));
    }
  }
}

void Mesh::require_bottom() const {
  for (std::size_t k = 0; k < plan.nodes() && !free_bottom; ++k) {
    const double level = bottom ? bottom->slope(x[k], y[k]).elevation : z[0];
    const double allowed = bottom ? on_bottom * std::abs(level) : 0;
    if (std::abs(z[k] - level) <= allowed) continue;
    throw std::invalid_argument(fmt::format("z = {:.17g} of bottom node {}; allowed: {}, {:.17g}", z[k], k,
                                            bottom ? "that of the bottom" : "that of all others", level));
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

}  // namespace seiche::lagrangian_mesh_3d
