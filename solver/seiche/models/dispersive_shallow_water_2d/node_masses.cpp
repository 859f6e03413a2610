#include "seiche/models/dispersive_shallow_water_2d/node_masses.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::dispersive_shallow_water_2d {

using plan_lattice::BoundNode;

namespace {

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// The direction along a wall and the bottom.
Vector along_wall_and_bottom(Point wall, double nx, double ny, double nz) {
  const Vector way{-nz * wall.y, nz * wall.x, nx * wall.y - ny * wall.x};
  const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  return {way.x / length, way.y / length, way.z / length};
}

}  // namespace

NodeMasses::NodeMasses(plan_lattice::Shape shape, const plan_lattice::Sides& sides, std::span<const double> x,
                       std::span<const double> y, double inertia)
    : shape_(shape),
      inertia_(inertia),
      bound_(plan_lattice::bound_nodes(shape, sides, x, y, true)),
      mass_(shape.nodes(), 0.0),
      inverse_(shape.nodes()),
      full_(shape.rows + 1, 0) {
  for (const BoundNode& bound : bound_) {
    for (std::size_t d = 0; d < bound.directions; ++d) has_driven_sides_ |= bound.driven[d] != nullptr;
    // Sliding along x or y leaves W diagonal.
    const bool slanted = bound.directions == 1 && std::abs(bound.normal[0].x * bound.normal[0].y) > 0;
    if (slanted || (bound.directions == 1 && bound.driven[0] != nullptr)) full_[bound.node / (shape.columns + 1)] = 1;
  }
}

void NodeMasses::stand_on_level_bottom() {
  for (std::size_t k = 0; k < mass_.size(); ++k) set(k, 0, 0, 1);
  for (const BoundNode& bound : bound_) bind(bound, 0, 0, 1);
}

void NodeMasses::stand_on(const Normals& normals) {
  std::fill(full_.begin(), full_.end(), 1);
  for (std::size_t k = 0; k < mass_.size(); ++k) set(k, normals.x[k], normals.y[k], normals.z[k]);
  for (const BoundNode& bound : bound_) {
    bind(bound, normals.x[bound.node], normals.y[bound.node], normals.z[bound.node]);
  }
}

void NodeMasses::turn_driven_sides(std::span<const double> x, std::span<const double> y, const Normals* normals) {
  for (BoundNode& bound : bound_) {
    bool turned = false;
    for (std::size_t d = 0; d < bound.directions; ++d) {
      if (bound.driven[d] == nullptr) continue;
      bound.normal[d] = plan_lattice::chord_normal(bound.chord[d], x, y);
      turned = true;
    }
    if (!turned) continue;
    const std::size_t k = bound.node;
    if (normals == nullptr) {
      bind(bound, 0, 0, 1);
    } else {
      bind(bound, normals->x[k], normals->y[k], normals->z[k]);
    }
  }
}

void NodeMasses::set(std::size_t node, double nx, double ny, double nz) {
  const double inverse = 1 / mass_[node];
  const double more = inverse * (1 / inertia_ - 1);
  inverse_.xx[node] = inverse + more * nx * nx;
  inverse_.yy[node] = inverse + more * ny * ny;
  inverse_.zz[node] = inverse + more * nz * nz;
  inverse_.xy[node] = more * nx * ny;
  inverse_.xz[node] = more * nx * nz;
  inverse_.yz[node] = more * ny * nz;
}

void NodeMasses::bind_to_shore(const BoundNode& bound, double nx, double ny, double nz) {
  const std::size_t k = bound.node;
  const double inverse = 1 / mass_[k];
  inverse_.xx[k] = inverse_.yy[k] = inverse_.zz[k] = inverse_.xy[k] = inverse_.xz[k] = inverse_.yz[k] = 0;
  const auto add = [&](double weight, Vector v) {
    inverse_.xx[k] += weight * v.x * v.x;
    inverse_.yy[k] += weight * v.y * v.y;
    inverse_.zz[k] += weight * v.z * v.z;
    inverse_.xy[k] += weight * v.x * v.y;
    inverse_.xz[k] += weight * v.x * v.z;
    inverse_.yz[k] += weight * v.y * v.z;
  };
  if (bound.directions == 1) add(inverse, along_wall_and_bottom(bound.normal[0], nx, ny, nz));
  if (bound.directions != 0) return;
  inverse_.xx[k] = inverse_.yy[k] = inverse_.zz[k] = inverse;
  add(-inverse, {nx, ny, nz});
}

void NodeMasses::bind(const BoundNode& bound, double nx, double ny, double nz) {
  if (bound.shore) {
    bind_to_shore(bound, nx, ny, nz);
    return;
  }
  const std::size_t k = bound.node;
  const double m = mass_[k];
  const double less = 1 - inertia_;
  const double up = m * (1 - less * nz * nz);
  if (bound.directions == 2) {
    inverse_.xx[k] = inverse_.yy[k] = inverse_.xy[k] = inverse_.xz[k] = inverse_.yz[k] = 0;
    inverse_.zz[k] = 1 / up;
    return;
  }
  const Point t{-bound.normal[0].y, bound.normal[0].x};
  const double nt = nx * t.x + ny * t.y;
  const double along = m * (1 - less * nt * nt);
  const double both = -m * less * nt * nz;
  const double determinant = along * up - both * both;
  const double w_along = up / determinant;
  const double w_both = -both / determinant;
  inverse_.xx[k] = w_along * t.x * t.x;
  inverse_.yy[k] = w_along * t.y * t.y;
  inverse_.xy[k] = w_along * t.x * t.y;
  inverse_.xz[k] = w_both * t.x;
  inverse_.yz[k] = w_both * t.y;
  inverse_.zz[k] = along / determinant;
}

void NodeMasses::carry(const Normals& from, const Normals& to, std::span<double> u) const {
  const std::size_t n = mass_.size();
  auto bound = bound_.begin();
  for (std::size_t k = 0; k < n; ++k) {
    if (bound != bound_.end() && bound->node == k) {
      const auto& here = *bound++;
      const bool rotates = here.shore && here.directions == 0;
      if (!rotates && here.driven[0] == nullptr && here.driven[1] == nullptr) {
        carry_along_side(here, from, to, u);
        continue;
      }
    }
    // The rotation about c = n0 x n1: a -> (n0.n1) a + c x a + c (c.a)/(1 + n0.n1).
    const double cx = from.y[k] * to.z[k] - from.z[k] * to.y[k];
    const double cy = from.z[k] * to.x[k] - from.x[k] * to.z[k];
    const double cz = from.x[k] * to.y[k] - from.y[k] * to.x[k];
    const double d = from.x[k] * to.x[k] + from.y[k] * to.y[k] + from.z[k] * to.z[k];
    const double ax = u[k];
    const double ay = u[n + k];
    const double az = u[2 * n + k];
    const double along = (cx * ax + cy * ay + cz * az) / (1 + d);
    u[k] = d * ax + (cy * az - cz * ay) + along * cx;
    u[n + k] = d * ay + (cz * ax - cx * az) + along * cy;
    u[2 * n + k] = d * az + (cx * ay - cy * ax) + along * cz;
  }
}

/// What a side leaves of M is m [I - (1 - alpha) p p^T] with p, the normal's projection on the plane of the side: its
/// axes are turned into those of the other bottom, and the motion along p is stretched to keep its energy.
void NodeMasses::carry_along_side(const plan_lattice::BoundNode& bound, const Normals& from, const Normals& to,
                                  std::span<double> u) const {
  const std::size_t n = mass_.size();
  const std::size_t k = bound.node;
  if (bound.shore) {
    const Vector before = along_wall_and_bottom(bound.normal[0], from.x[k], from.y[k], from.z[k]);
    const Vector after = along_wall_and_bottom(bound.normal[0], to.x[k], to.y[k], to.z[k]);
    const double rate = bound.directions == 2 ? 0 : u[k] * before.x + u[n + k] * before.y + u[2 * n + k] * before.z;
    u[k] = rate * after.x;
    u[n + k] = rate * after.y;
    u[2 * n + k] = rate * after.z;
    return;
  }
  if (bound.directions == 2) return;  // rises and falls above one place, whose normal stays
  const Point t{-bound.normal[0].y, bound.normal[0].x};
  const Point before{from.x[k] * t.x + from.y[k] * t.y, from.z[k]};
  const Point after{to.x[k] * t.x + to.y[k] * t.y, to.z[k]};
  const double square_before = before.x * before.x + before.y * before.y;
  const double square_after = after.x * after.x + after.y * after.y;
  const Point a{u[k] * t.x + u[n + k] * t.y, u[2 * n + k]};
  const double scale = 1 / std::sqrt(square_before * square_after);
  const double less = 1 - inertia_;
  const double normal =
      scale * (a.x * before.x + a.y * before.y) * std::sqrt((1 - less * square_before) / (1 - less * square_after));
  const double tangential = scale * (a.x * before.y - a.y * before.x);
  const double along = normal * after.x + tangential * after.y;
  u[k] = along * t.x;
  u[n + k] = along * t.y;
  u[2 * n + k] = normal * after.y - tangential * after.x;
}

void NodeMasses::constrain(std::span<const double> q, double time, const Normals* normals, bool all,
                           std::span<double> u) const {
  const std::size_t n = mass_.size();
  for (const BoundNode& bound : bound_) {
    const bool driven = bound.driven[0] != nullptr || bound.driven[1] != nullptr;
    if (!driven && !all) continue;
    const std::size_t k = bound.node;
    const double nx = normals == nullptr ? 0 : normals->x[k];
    const double ny = normals == nullptr ? 0 : normals->y[k];
    const double nz = normals == nullptr ? 1 : normals->z[k];
    if (bound.shore) {
      // On the bottom M is m I.
      const double off = u[k] * nx + u[n + k] * ny + u[2 * n + k] * nz;
      u[k] -= off * nx;
      u[n + k] -= off * ny;
      u[2 * n + k] -= off * nz;
    }
    if (bound.shore && bound.directions == 2) u[k] = u[n + k] = u[2 * n + k] = 0;
    if (bound.shore && bound.directions != 1) continue;
    std::array<double, 2> defect{};
    for (std::size_t d = 0; d < bound.directions; ++d) {
      const Point normal = bound.normal[d];
      double speed = 0;
      if (bound.driven[d] != nullptr) {
        const Point velocity = bound.driven[d]->velocity({q[k], q[n + k], q[2 * n + k]}, time);
        speed = velocity.x * normal.x + velocity.y * normal.y;
      }
      defect[d] = u[k] * normal.x + u[n + k] * normal.y - speed;
    }
    // u -= W0 N (N^T W0 N)^-1 defect with m W0 = I + more n n^T.
    const double more = bound.shore ? -1 : 1 / inertia_ - 1;
    const auto slope = [&](std::size_t d) { return nx * bound.normal[d].x + ny * bound.normal[d].y; };
    const auto product = [&](std::size_t a, std::size_t b) {
      return bound.normal[a].x * bound.normal[b].x + bound.normal[a].y * bound.normal[b].y + more * slope(a) * slope(b);
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
      u[k] -= impulse[d] * (bound.normal[d].x + more * slope(d) * nx);
      u[n + k] -= impulse[d] * (bound.normal[d].y + more * slope(d) * ny);
      u[2 * n + k] -= impulse[d] * more * slope(d) * nz;
    }
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
