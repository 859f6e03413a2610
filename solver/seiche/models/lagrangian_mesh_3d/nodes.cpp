#include "seiche/models/lagrangian_mesh_3d/nodes.hpp"

#include <cmath>
#include <utility>

#include "seiche/lattice/water.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

/// Directions closer to an axis than this are along it: far above round-off, far below any angle that is meant.
constexpr double parallel = 1e-12;

}  // namespace

Nodes::Nodes(const Mesh& mesh, std::span<const double> volumes, double density)
    : sides_(std::make_shared<const Sides>(mesh.sides)),
      bottom_(mesh.bottom),
      held_below_(mesh.free_bottom ? 0 : mesh.plan.nodes()),
      freedom_(mesh.plan.nodes()),
      on_bottom_(mesh.bottom ? mesh.plan.nodes() : 0) {
  const std::size_t level = mesh.plan.nodes();
  for (const plan_lattice::BoundNode& bound :
       plan_lattice::bound_nodes(mesh.plan, *sides_, std::span(mesh.x).first(level), std::span(mesh.y).first(level))) {
    const Point n = bound.normal[0];
    freedom_[bound.node] = std::abs(n.x) < parallel   ? HorizontalFreedom{1, 0, 0}
                           : std::abs(n.y) < parallel ? HorizontalFreedom{0, 1, 0}
                                                      : HorizontalFreedom{n.y * n.y, n.x * n.x, -n.x * n.y};
    if (bound.directions == 2 || bound.is_driven()) freedom_[bound.node] = {0, 0, 0};
    const std::size_t wall = bound.driven[0] == nullptr ? 0 : 1;
    const bool ends_at_wall = bound.directions == 2 && bound.driven[wall] == nullptr;
    for (std::size_t k = bound.node; bound.is_driven() && k < mesh.nodes(); k += level) {
      driven_.push_back({k, bound.driven[1 - wall], ends_at_wall ? bound.normal[wall] : Point{}});
    }
  }
  weigh(mesh, volumes, density);
}

void Nodes::weigh(const Mesh& mesh, std::span<const double> volumes, double density) {
  mass_.assign(mesh.nodes(), 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const std::size_t k : mesh.corners(cell)) mass_[k] += density * volumes[cell] / 8;
  }
  for (std::vector<double>& w : w_) w.assign(mass_.size(), 0.0);
  slanted_.clear();
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    if (k < on_bottom_.size() || freedom_[k % freedom_.size()].xy != 0) {
      slanted_.push_back(k);
    } else {
      const Symmetric p = left(k);
      for (std::size_t axis = 0; axis < 3; ++axis) w_[axis][k] = p[axis] / mass_[k];
    }
  }
}

void Nodes::turn(mechanics::Input q0, mechanics::Input q1) {
  static constexpr std::array here{GaussPoint{0, 1}};
  const auto points = q0.data() == q1.data() ? std::span<const GaussPoint>(here) : std::span(gauss_points());
  const std::size_t n = mass_.size();
  for (std::size_t k = 0; k < on_bottom_.size(); ++k) {
    Point slope;
    for (const auto& [part, weight] : points) {
      const auto at = bottom_->slope(q0[k] + part * (q1[k] - q0[k]), q0[n + k] + part * (q1[n + k] - q0[n + k]));
      slope.x += weight * at.along_x;
      slope.y += weight * at.along_y;
    }
    const auto [xx, yy, xy] = freedom_[k];
    const double x = -(xx * slope.x + xy * slope.y);
    const double y = -(xy * slope.x + yy * slope.y);
    const double square = x * x + y * y + 1;
    on_bottom_[k] = {xx - x * x / square, yy - y * y / square, 1 - 1 / square,
                     xy - x * y / square, -x / square,         -y / square};
  }
}

Nodes::Symmetric Nodes::left(std::size_t node) const {
  if (node < on_bottom_.size()) return on_bottom_[node];
  const auto [xx, yy, xy] = freedom_[node % freedom_.size()];
  return {xx, yy, node < held_below_ ? 0.0 : 1.0, xy, 0, 0};
}

void Nodes::project(std::size_t nodes, std::span<double> u) const {
  for (std::size_t k = 0; k < nodes; ++k) {
    const Vector v = vector_at(u, k);
    const auto kept = lattice::times(left(k), {v.x, v.y, v.z});
    put_vector({kept[0], kept[1], kept[2]}, k, u);
  }
}

}  // namespace seiche::lagrangian_mesh_3d
