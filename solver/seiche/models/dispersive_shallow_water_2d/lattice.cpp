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
  require_at_least("columns", static_cast<long>(shape.columns), 2);
  require_at_least("rows", static_cast<long>(shape.rows), 1);
  require_positive("depth", depth);
  for (const auto& [name, values] : {std::pair{"x", &x}, std::pair{"y", &y}, std::pair{"z", &z}}) {
    require_that(values->size() == shape.nodes(), "{} has {} values; allowed: {}, one per node of {} x {} cells", name,
                 values->size(), shape.nodes(), shape.columns, shape.rows);
    const auto bad = std::find_if(values->begin(), values->end(), [](double value) { return !std::isfinite(value); });
    if (bad == values->end()) continue;
    throw std::invalid_argument(fmt::format("{}[{}] = {}; allowed: finite", name, bad - values->begin(), *bad));
  }
  const auto bottom_below = [this](double at_x, double at_y) {
    try {
      return bottom ? bottom->slope(at_x, at_y).elevation : -depth;
    } catch (const Infeasible& outside) {
      throw std::invalid_argument(outside.what());
    }
  };
  std::vector<char> on_shore(shape.nodes(), 0);
  for (const auto& edge : plan_lattice::shore_edges(shape, sides)) {
    require_that(bottom != nullptr, "a shoreline over a level bottom; allowed: an uneven bottom");
    for (const std::size_t k : edge) on_shore[k] = 1;
  }
  std::vector<double> bed(shape.nodes());
  double deepest = 0;
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    bed[k] = bottom_below(x[k], y[k]);
    deepest = std::max(deepest, z[k] - bed[k]);
  }
  for (std::size_t k = 0; k < shape.nodes(); ++k) {
    const double under = bed[k];
    require_that(on_shore[k] == 0 || std::abs(z[k] - under) <= 1e-12 * deepest,
                 "z = {:.17g} at ({:g}, {:g}); allowed: the bottom's elevation {:.17g} to 1e-12 of the largest depth, "
                 "it is on a shoreline",
                 z[k], x[k], y[k], under);
    require_that(on_shore[k] != 0 || z[k] > under, "z = {:g} at ({:g}, {:g}); allowed: above the bottom, {:g}", z[k],
                 x[k], y[k], under);
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
  for (const auto& [name, from, to] :
       {std::tuple{"end", rectangle.begin, rectangle.end}, std::tuple{"north", rectangle.south, rectangle.north}}) {
    require_finite(name, to);
    require_that(to > from, "{} = {:g}; allowed: above {:g}", name, to, from);
  }
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

Vector3 normal_at(const Normals* normals, std::size_t k) {
  return normals == nullptr ? Vector3{0, 0, 1} : (*normals)[k];
}

Vector3 horizontal(Point p) {
  return {p.x, p.y, 0};
}

/// The direction along a wall and the bottom.
Vector3 along_wall_and_bottom(Point wall, Vector3 n) {
  const Vector3 way = cross(n, horizontal(wall));
  return way / std::sqrt(dot(way, way));
}

/// one I + more v v^T
Symmetric with_dyad(double one, double more, Vector3 v) {
  return {one + more * v.x * v.x, one + more * v.y * v.y, one + more * v.z * v.z,
          more * v.x * v.y,       more * v.x * v.z,       more * v.y * v.z};
}

/// Of a node that sides bind. @param inertia  alpha
Symmetric bound_inverse(const BoundNode& bound, double mass, double inertia, Vector3 n) {
  if (bound.shore) {
    if (bound.directions == 0) return with_dyad(1 / mass, -1 / mass, n);
    if (bound.directions == 2) return {};
    return with_dyad(0, 1 / mass, along_wall_and_bottom(bound.normal[0], n));
  }
  const double less = 1 - inertia;
  const double up = mass * (1 - less * n.z * n.z);
  if (bound.directions == 2) return {0, 0, 1 / up, 0, 0, 0};
  const Point t{-bound.normal[0].y, bound.normal[0].x};
  const double nt = n.x * t.x + n.y * t.y;
  const double along = mass * (1 - less * nt * nt);
  const double both = -mass * less * nt * n.z;
  const double determinant = along * up - both * both;
  const double w_along = up / determinant;
  const double w_both = -both / determinant;
  return {w_along * t.x * t.x, w_along * t.y * t.y, along / determinant,
          w_along * t.x * t.y, w_both * t.x,        w_both * t.y};
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

void NodeMasses::stand_on(const Normals* normals) {
  if (normals != nullptr) std::ranges::fill(full_, char{1});
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    const double inverse = 1 / mass_[k];
    inverse_.put(k, with_dyad(inverse, inverse * (1 / inertia_ - 1), normal_at(normals, k)));
  }
  for (const BoundNode& bound : bound_) bind(bound, normals);
}

void NodeMasses::turn_driven_sides(std::span<const double> x, std::span<const double> y, const Normals* normals) {
  for (BoundNode& bound : bound_) {
    if (!bound.is_driven()) continue;
    for (std::size_t d = 0; d < bound.directions; ++d) {
      if (bound.driven[d] != nullptr) bound.normal[d] = plan_lattice::chord_normal(bound.chord[d], x, y);
    }
    bind(bound, normals);
  }
}

void NodeMasses::bind(const BoundNode& bound, const Normals* normals) {
  inverse_.put(bound.node, bound_inverse(bound, mass_[bound.node], inertia_, normal_at(normals, bound.node)));
}

void NodeMasses::carry(const Normals& from, const Normals& to, std::span<double> u) const {
  auto bound = bound_.begin();
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    const Vector3 a = vector_at(u, k);
    if (bound != bound_.end() && bound->node == k) {
      const BoundNode& here = *bound++;
      const bool rotates = here.shore && here.directions == 0;
      if (!rotates && !here.is_driven()) {
        put_vector(carried_along_side(here, from[k], to[k], a), k, u);
        continue;
      }
    }
    // The rotation about c = n0 x n1: a -> (n0.n1) a + c x a + c (c.a)/(1 + n0.n1).
    const Vector3 c = cross(from[k], to[k]);
    const double d = dot(from[k], to[k]);
    put_vector(d * a + cross(c, a) + dot(c, a) / (1 + d) * c, k, u);
  }
}

/// What a side leaves of M is m [I - (1 - alpha) p p^T] with p, the normal's projection on the plane of the side: its
/// axes are turned into those of the other bottom, and the motion along p is stretched to keep its energy.
Vector3 NodeMasses::carried_along_side(const BoundNode& bound, Vector3 from, Vector3 to, Vector3 u) const {
  if (bound.shore) {
    const double rate = bound.directions == 2 ? 0 : dot(u, along_wall_and_bottom(bound.normal[0], from));
    return rate * along_wall_and_bottom(bound.normal[0], to);
  }
  if (bound.directions == 2) return u;  // rises and falls above one place, whose normal stays
  const Point t{-bound.normal[0].y, bound.normal[0].x};
  const Point before{from.x * t.x + from.y * t.y, from.z};
  const Point after{to.x * t.x + to.y * t.y, to.z};
  const Point a{u.x * t.x + u.y * t.y, u.z};
  const double square_before = dot(before, before);
  const double square_after = dot(after, after);
  const double scale = 1 / std::sqrt(square_before * square_after);
  const double less = 1 - inertia_;
  const double normal = scale * dot(a, before) * std::sqrt((1 - less * square_before) / (1 - less * square_after));
  const double tangential = scale * cross(a, before);
  const double along = normal * after.x + tangential * after.y;
  return {along * t.x, along * t.y, normal * after.y - tangential * after.x};
}

void NodeMasses::constrain(std::span<const double> q, double time, const Normals* normals, bool all,
                           std::span<double> u) const {
  for (const BoundNode& bound : bound_) {
    if (!bound.is_driven() && !all) continue;
    const std::size_t k = bound.node;
    const Vector3 n = normal_at(normals, k);
    Vector3 v = vector_at(u, k);
    // On the bottom M is m I.
    if (bound.shore) v = v - dot(v, n) * n;
    if (bound.shore && bound.directions == 2) v = {};
    if (!bound.shore || bound.directions == 1) {
      std::array<double, 2> defect{};
      for (std::size_t d = 0; d < bound.directions; ++d) {
        defect[d] = v.x * bound.normal[d].x + v.y * bound.normal[d].y;
        if (bound.driven[d] == nullptr) continue;
        const Vector3 place = vector_at(q, k);
        defect[d] -= dot(bound.driven[d]->velocity({place.x, place.y, place.z}, time), bound.normal[d]);
      }
      // u -= W0 N (N^T W0 N)^-1 defect with m W0 = I + more n n^T.
      const double more = bound.shore ? -1 : 1 / inertia_ - 1;
      const auto slope = [&](std::size_t d) { return n.x * bound.normal[d].x + n.y * bound.normal[d].y; };
      const auto product = [&](std::size_t a, std::size_t b) {
        return dot(bound.normal[a], bound.normal[b]) + more * slope(a) * slope(b);
      };
      std::array<double, 2> impulse{};
      if (bound.directions == 1) {
        impulse[0] = defect[0] / product(0, 0);
      } else {
        const double determinant = product(0, 0) * product(1, 1) - product(0, 1) * product(0, 1);
        impulse[0] = (product(1, 1) * defect[0] - product(0, 1) * defect[1]) / determinant;
        impulse[1] = (product(0, 0) * defect[1] - product(0, 1) * defect[0]) / determinant;
      }
      for (std::size_t d = 0; d < bound.directions; ++d) {
        v = v - impulse[d] * (horizontal(bound.normal[d]) + more * slope(d) * n);
      }
    }
    put_vector(v, k, u);
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
