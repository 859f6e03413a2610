#include "seiche/models/lagrangian_mesh_3d/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seiche/lattice/water.hpp"

namespace seiche::lagrangian_mesh_3d {

Bottom::Bottom(std::shared_ptr<const PlanBottom> bottom, std::vector<HorizontalFreedom> freedom)
    : bottom_(std::move(bottom)), freedom_(std::move(freedom)), left_(freedom_.size()) {}

void Bottom::turn(std::span<const double> x0, std::span<const double> y0, std::span<const double> x1,
                  std::span<const double> y1) {
  static const double outer = 0.5 * std::sqrt(0.6);
  static const std::array gauss{std::pair{0.5 - outer, 5.0 / 18}, std::pair{0.5, 8.0 / 18},
                                std::pair{0.5 + outer, 5.0 / 18}};
  static const std::array here{std::pair{0.0, 1.0}};
  const auto points = x0.data() == x1.data() ? std::span<const std::pair<double, double>>(here) : std::span(gauss);
  for (std::size_t k = 0; k < nodes(); ++k) {
    Point slope;
    for (const auto& [part, weight] : points) {
      const auto at = bottom_->slope(x0[k] + part * (x1[k] - x0[k]), y0[k] + part * (y1[k] - y0[k]));
      slope.x += weight * at.along_x;
      slope.y += weight * at.along_y;
    }
    const auto [xx, xy, yy] = freedom_[k];
    const double x = -(xx * slope.x + xy * slope.y);
    const double y = -(xy * slope.x + yy * slope.y);
    const double square = x * x + y * y + 1;
    left_[k] = {xx - x * x / square, yy - y * y / square, 1 - 1 / square,
                xy - x * y / square, -x / square,         -y / square};
  }
}

void Bottom::project(std::span<double> u) const {
  for (std::size_t k = 0; k < nodes(); ++k) {
    const Vector v = vector_at(u, k);
    const auto kept = lattice::times(left_[k], {v.x, v.y, v.z});
    put_vector({kept[0], kept[1], kept[2]}, k, u);
  }
}

namespace {

/// Directions closer to an axis than this are along it: far above round-off, far below any angle that is meant.
constexpr double parallel = 1e-12;

}  // namespace

Nodes::Nodes(const Mesh& mesh, std::span<const double> volumes, double density)
    : sides_(std::make_shared<const Sides>(mesh.sides)), freedom_(mesh.nodes(), along_x | along_y | along_z) {
  const std::size_t level = mesh.plan.nodes();
  const auto set = [&](std::size_t node, unsigned char freedom) {
    freedom_[node] = static_cast<unsigned char>((freedom_[node] & along_z) | freedom);
  };
  if (!mesh.free_bottom) std::fill_n(freedom_.begin(), level, static_cast<unsigned char>(along_x | along_y));
  for (const plan_lattice::BoundNode& bound :
       plan_lattice::bound_nodes(mesh.plan, *sides_, std::span(mesh.x).first(level), std::span(mesh.y).first(level))) {
    const plan_lattice::DrivenSide* driven = bound.driven[0] != nullptr ? bound.driven[0] : bound.driven[1];
    for (std::size_t l = 0; l <= mesh.layers; ++l) {
      const std::size_t node = l * level + bound.node;
      if (driven != nullptr) {
        const std::size_t wall = bound.driven[0] == nullptr ? 0 : 1;
        const bool ends_at_wall = bound.directions == 2 && bound.driven[wall] == nullptr;
        driven_.push_back({node, driven, ends_at_wall ? bound.normal[wall] : Point{}});
        set(node, 0);
      } else if (bound.directions == 2) {
        set(node, 0);
      } else if (std::abs(bound.normal[0].x) < parallel) {
        set(node, along_x);
      } else if (std::abs(bound.normal[0].y) < parallel) {
        set(node, along_y);
      } else {
        set(node, 0);
        slides_.push_back({node, {-bound.normal[0].y, bound.normal[0].x}});
      }
    }
  }
  if (mesh.bottom) leave_to_bottom(level);
  std::sort(slides_.begin(), slides_.end(), [](const Slide& a, const Slide& b) { return a.node < b.node; });
  weigh(mesh, volumes, density);
}

void Nodes::leave_to_bottom(std::size_t level) {
  for (std::size_t k = 0; k < level; ++k) {
    on_bottom_.push_back(
        {.xx = (freedom_[k] & along_x) != 0 ? 1.0 : 0.0, .xy = 0, .yy = (freedom_[k] & along_y) != 0 ? 1.0 : 0.0});
    freedom_[k] = 0;
  }
  std::erase_if(slides_, [&](const Slide& slide) {
    if (slide.node >= level) return false;
    const Point t = slide.direction;
    on_bottom_[slide.node] = {.xx = t.x * t.x, .xy = t.x * t.y, .yy = t.y * t.y};
    return true;
  });
}

void Nodes::weigh(const Mesh& mesh, std::span<const double> volumes, double density) {
  mass_.assign(mesh.nodes(), 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const std::size_t k : mesh.corners(cell)) mass_[k] += density * volumes[cell] / 8;
  }
  constexpr std::array freedoms{along_x, along_y, along_z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    w_[axis].resize(mass_.size());
    for (std::size_t k = 0; k < mass_.size(); ++k) {
      w_[axis][k] = (freedom_[k] & freedoms[axis]) != 0 ? 1 / mass_[k] : 0.0;
    }
  }
}

Vector Nodes::allowed(std::size_t node, const Vector& velocity) const {
  const Vector free{w_[0][node] > 0 ? velocity.x : 0.0, w_[1][node] > 0 ? velocity.y : 0.0,
                    w_[2][node] > 0 ? velocity.z : 0.0};
  const auto slide =
      std::lower_bound(slides_.begin(), slides_.end(), node, [](const Slide& s, std::size_t k) { return s.node < k; });
  if (slide == slides_.end() || slide->node != node) return free;
  const double speed = slide->direction.x * velocity.x + slide->direction.y * velocity.y;
  return {speed * slide->direction.x, speed * slide->direction.y, free.z};
}

}  // namespace seiche::lagrangian_mesh_3d
