#include "seiche/models/dispersive_shallow_water_2d/node_masses.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::dispersive_shallow_water_2d {

using plan_lattice::BoundNode;

NodeMasses::NodeMasses(plan_lattice::Shape shape, const plan_lattice::Sides& sides, std::span<const double> x,
                       std::span<const double> y, double inertia)
    : shape_(shape),
      inertia_(inertia),
      bound_(plan_lattice::bound_nodes(shape, sides, x, y)),
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

void NodeMasses::bind(const BoundNode& bound, double nx, double ny, double nz) {
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
    const double more = 1 / inertia_ - 1;
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
