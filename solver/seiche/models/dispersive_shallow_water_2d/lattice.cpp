#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::dispersive_shallow_water_2d {

void Lattice::require_valid() const {
  plan_lattice::require_places(shape, 2, 1, {{"x", x}, {"y", y}, {"z", z}});
  require_positive("depth", depth);
  std::vector<char> on_shore(shape.nodes(), 0);
  for (const auto& edge : plan_lattice::shore_edges(shape, sides)) {
    require_that(bottom != nullptr, "a shoreline over a level bottom; allowed: an uneven bottom");
    for (const std::size_t k : edge) on_shore[k] = 1;
  }
  std::vector<double> under(shape.nodes());
  double deepest = 0;
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    try {
      under[k] = bed(x[k], y[k]);
    } catch (const Infeasible& outside) {
      throw std::invalid_argument(outside.what());
    }
    deepest = std::max(deepest, z[k] - under[k]);
  }
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    require_that(on_shore[k] == 0 || std::abs(z[k] - under[k]) <= 1e-12 * deepest,
                 "z = {:.17g} at ({:g}, {:g}); allowed: the bottom's elevation {:.17g} to 1e-12 of the largest depth, "
                 "it is on a shoreline",
                 z[k], x[k], y[k], under[k]);
    require_that(on_shore[k] != 0 || z[k] > under[k], "z = {:g} at ({:g}, {:g}); allowed: above the bottom, {:g}", z[k],
                 x[k], y[k], under[k]);
  }
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto corners = shape.corners(cell);
    const auto at = [&](std::span<const double> values) { return bilinear_patch::at_corners(values, corners); };
    require_that(bilinear_patch::smallest(bilinear_patch::jacobians(at(x), at(y))) > 0,
                 "cell {} at ({:g}, {:g}) is not convex, or its corners do not go around "
                 "anticlockwise; allowed: x grows with the column, y with the row",
                 cell, x[corners[0]], y[corners[0]]);
  }
}

Lattice rectangular_lattice(const Rectangle& rectangle) {
  plan_lattice::require_ascending("begin", rectangle.begin, "end", rectangle.end);
  plan_lattice::require_ascending("south", rectangle.south, "north", rectangle.north);
  require_at_least("columns", static_cast<long>(rectangle.columns), 2);
  require_at_least("rows", static_cast<long>(rectangle.rows), 1);
  Lattice lattice{.shape = {rectangle.columns, rectangle.rows},
                  .x = {},
                  .y = {},
                  .z = {},
                  .sides = rectangle.sides,
                  .depth = rectangle.depth,
                  .bottom = rectangle.bottom};
  for (std::size_t j = 0; j <= rectangle.rows; ++j) {
    for (std::size_t i = 0; i <= rectangle.columns; ++i) {
      lattice.x.push_back(plan_lattice::equally_spaced(rectangle.begin, rectangle.end, i, rectangle.columns));
      lattice.y.push_back(plan_lattice::equally_spaced(rectangle.south, rectangle.north, j, rectangle.rows));
      lattice.z.push_back(rectangle.elevation ? rectangle.elevation(lattice.x.back(), lattice.y.back()) : 0.0);
    }
  }
  return lattice;
}

using plan_lattice::BoundNode;

namespace {

using Symmetric = std::array<double, 6>;  // xx, yy, zz, xy, xz, yz

Vector3 horizontal(Point p) {
  return {p.x, p.y, 0};
}

/// The direction along a wall and the bottom.
Vector3 along_wall_and_bottom(Point wall, Vector3 n) {
  const Vector3 way = cross(n, horizontal(wall));
  return way / std::sqrt(dot(way, way));
}

/// w + more v v^T
Symmetric with_dyad(const Symmetric& w, double more, Vector3 v) {
  return {w[0] + more * v.x * v.x, w[1] + more * v.y * v.y, w[2] + more * v.z * v.z,
          w[3] + more * v.x * v.y, w[4] + more * v.x * v.z, w[5] + more * v.y * v.z};
}

/// Of a node that sides bind. @param inertia  alpha
Symmetric bound_inverse(const BoundNode& bound, double mass, double inertia, Vector3 n) {
  const double m = 1 / mass;
  if (bound.shore) {
    if (bound.directions == 0) return with_dyad({m, m, m}, -m, n);
    return bound.directions == 2 ? Symmetric{} : with_dyad({}, m, along_wall_and_bottom(bound.normal[0], n));
  }
  const Vector3 t = bound.directions == 2 ? Vector3{} : Vector3{-bound.normal[0].y, bound.normal[0].x, 0};
  const Vector3 p = dot(n, t) * t + Vector3{0, 0, n.z};
  const double less = 1 - inertia;
  return with_dyad(with_dyad({0, 0, m}, m, t), m * less / (1 - less * dot(p, p)), p);
}

/// By the smallest rotation that takes one unit vector to another: about c = n0 x n1,
/// a -> (n0.n1) a + c x a + c (c.a)/(1 + n0.n1).
Vector3 turned(Vector3 a, Vector3 from, Vector3 to) {
  const Vector3 c = cross(from, to);
  const double d = dot(from, to);
  return d * a + cross(c, a) + dot(c, a) / (1 + d) * c;
}

}  // namespace

NodeMasses::NodeMasses(plan_lattice::Shape shape, const plan_lattice::Sides& sides, std::span<const double> x,
                       std::span<const double> y, double inertia)
    : inertia_(inertia),
      bound_(plan_lattice::bound_nodes(shape, sides, x, y, true)),
      mass_(shape.nodes(), 0.0),
      inverse_(shape.nodes()),
      full_(shape.rows + 1, 0) {
  for (const BoundNode& bound : bound_) {
    has_driven_sides_ |= bound.is_driven();
    // Sliding along x or y leaves W diagonal.
    const bool slanted = bound.directions == 1 && std::abs(bound.normal[0].x * bound.normal[0].y) > 0;
    if (slanted || (bound.directions == 1 && bound.is_driven())) full_[bound.node / (shape.columns + 1)] = 1;
  }
}

void NodeMasses::stand_on(const Normals& normals) {
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    const double m = 1 / mass_[k];
    inverse_.put(k, with_dyad({m, m, m}, m * (1 / inertia_ - 1), normals[k]));
    if (normals[k].x != 0 || normals[k].y != 0) full_[k * full_.size() / mass_.size()] = 1;
  }
  for (const BoundNode& bound : bound_) bind(bound, normals);
}

void NodeMasses::turn_driven_sides(std::span<const double> x, std::span<const double> y, const Normals& normals) {
  for (BoundNode& bound : bound_) {
    if (!bound.is_driven()) continue;
    for (std::size_t d = 0; d < bound.directions; ++d) {
      if (bound.driven[d] != nullptr) bound.normal[d] = plan_lattice::chord_normal(bound.chord[d], x, y);
    }
    bind(bound, normals);
  }
}

void NodeMasses::bind(const BoundNode& bound, const Normals& normals) {
  inverse_.put(bound.node, bound_inverse(bound, mass_[bound.node], inertia_, normals[bound.node]));
}

void NodeMasses::carry(const Normals& from, const Normals& to, std::span<double> u) const {
  auto bound = bound_.begin();
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    const Vector3 a = vector_at(u, k);
    const bool is_bound = bound != bound_.end() && bound->node == k;
    const bool keeps_side = is_bound && !bound->is_driven() && !(bound->shore && bound->directions == 0);
    put_vector(keeps_side ? carried_along_side(*bound, from[k], to[k], a) : turned(a, from[k], to[k]), k, u);
    if (is_bound) ++bound;
  }
}

/// What a side leaves of M is m [I - (1 - alpha) p p^T] with p, the normal's projection on the plane of the side: p is
/// turned into that of the other bottom, and the motion along it is stretched to keep its energy.
Vector3 NodeMasses::carried_along_side(const BoundNode& bound, Vector3 from, Vector3 to, Vector3 u) const {
  if (bound.directions == 2) return bound.shore ? Vector3{} : u;  // rises and falls above one place
  const Vector3 wall = horizontal(bound.normal[0]);
  if (bound.shore) {
    return dot(u, along_wall_and_bottom(bound.normal[0], from)) * along_wall_and_bottom(bound.normal[0], to);
  }
  const Vector3 before = from - dot(from, wall) * wall;
  const Vector3 after = to - dot(to, wall) * wall;
  const double square_before = dot(before, before);
  const double square_after = dot(after, after);
  const double less = 1 - inertia_;
  const Vector3 v = turned(u, before / std::sqrt(square_before), after / std::sqrt(square_after));
  const double stretch = std::sqrt((1 - less * square_before) / (1 - less * square_after));
  return v + (stretch - 1) / square_after * dot(v, after) * after;
}

void NodeMasses::constrain(std::span<const double> q, double time, const Normals& normals, bool all,
                           std::span<double> u) const {
  for (const BoundNode& bound : bound_) {
    if (!bound.is_driven() && !all) continue;
    const std::size_t k = bound.node;
    const Vector3 n = normals[k];
    // One direction after the other along W0 N, m W0 = I + more n n^T; the second without what the first one forbids.
    // On a shoreline M is m I.
    const double more = bound.shore ? -1 : 1 / inertia_ - 1;
    Vector3 v = bound.shore ? vector_at(u, k) - dot(vector_at(u, k), n) * n : vector_at(u, k);
    if (bound.shore && bound.directions == 2) v = {};
    std::array<Vector3, 2> across, way;
    for (std::size_t d = 0; d < bound.directions && !(bound.shore && bound.directions == 2); ++d) {
      across[d] = horizontal(bound.normal[d]);
      way[d] = across[d] + more * dot(across[d], n) * n;
      if (d == 1) way[1] = way[1] - dot(across[0], way[1]) / dot(across[0], way[0]) * way[0];
      double excess = dot(across[d], v);
      if (bound.driven[d] != nullptr) excess -= dot(bound.driven[d]->velocity(vector_at(q, k), time), bound.normal[d]);
      v = v - excess / dot(across[d], way[d]) * way[d];
    }
    put_vector(v, k, u);
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
