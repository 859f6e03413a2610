#include "seiche/models/lagrangian_mesh_2d/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

bool vertical(const Wall& wall) {
  const auto* line = dynamic_cast<const Line*>(wall.curve.get());
  return line != nullptr && line->tangent(0).x == 0;
}

bool level(const Wall& wall) {
  const auto* line = dynamic_cast<const Line*>(wall.curve.get());
  return line != nullptr && line->tangent(0).y == 0;
}

/// Level and unbent to rounding: a node that is driven along x does not leave the curve then.
bool level_at(const Wall& wall, Point place) {
  const double s = wall.curve->arc_length_at(place);
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  return std::abs(wall.curve->tangent(s).y) <= rounding && std::abs(wall.curve->curvature(s).y) <= rounding;
}

}  // namespace

Nodes::Nodes(const Mesh& mesh, std::span<const double> areas, double density, bool tuned_surface_inertia)
    : sides_(std::make_shared<const Sides>(mesh.sides)), label_x_(mesh.x), label_y_(mesh.y), mass_(mesh.nodes(), 0.0) {
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const std::size_t node : mesh.corners(cell)) mass_[node] += 0.25 * density * areas[cell];
  }
  inertia_y_ = mass_;
  if (tuned_surface_inertia) {
    for (std::size_t i = 0; i <= mesh.columns; ++i) {
      const std::size_t top = mesh.node(i, mesh.rows);
      const double depth = mesh.y[top] - mesh.y[mesh.node(i, 0)];
      const double row = mesh.y[top] - mesh.y[mesh.node(i, mesh.rows - 1)];
      inertia_y_[top] *= 1 - row / (3 * depth);
    }
  }
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    wx_.push_back(1 / mass_[k]);
    wy_.push_back(1 / inertia_y_[k]);
  }
  const Sides& sides = *sides_;
  for (std::size_t i = 1; i < mesh.columns; ++i) {
    hold(mesh, mesh.node(i, 0), {&sides.bottom});
    hold(mesh, mesh.node(i, mesh.rows), {&sides.top});
  }
  for (std::size_t j = 1; j < mesh.rows; ++j) {
    hold(mesh, mesh.node(0, j), {&sides.left});
    hold(mesh, mesh.node(mesh.columns, j), {&sides.right});
  }
  for (const std::size_t i : {std::size_t{0}, mesh.columns}) {
    for (const std::size_t j : {std::size_t{0}, mesh.rows}) hold_corner(mesh, i, j);
  }
}

void Nodes::hold_corner(const Mesh& mesh, std::size_t i, std::size_t j) {
  const Side& beside = i == 0 ? sides_->left : sides_->right;
  const Side& across = j == 0 ? sides_->bottom : sides_->top;
  const std::size_t node = mesh.node(i, j);
  const auto* wall = std::get_if<Wall>(&beside);
  const bool contact = wall != nullptr && std::holds_alternative<FreeSide>(across);
  require_that(!contact || !level(*wall),
               "the free side ends at a level wall, at ({:g}, {:g}); allowed: walls with a slope", mesh.x[node],
               mesh.y[node]);
  hold(mesh, node, {&beside, &across});
  if (contact && !slides_.empty() && slides_.back().node == node) {
    // Pi = ... + W at the left end of the surface, - W at its right end; reversed at a free bottom.
    slides_.back().contact_sign = (i == 0) == (j != 0) ? 1 : -1;
  }
}

void Nodes::hold(const Mesh& mesh, std::size_t node, const std::vector<const Side*>& sides) {
  const MovingWall* moving = nullptr;
  const PrescribedSide* path = nullptr;
  std::vector<const Wall*> walls;
  for (const Side* side : sides) {
    if (const auto* wall = std::get_if<Wall>(side)) walls.push_back(wall);
    if (const auto* given = std::get_if<MovingWall>(side)) moving = given;
    if (const auto* given = std::get_if<PrescribedSide>(side)) path = given;
  }
  if (path != nullptr) {
    wx_[node] = wy_[node] = 0;
    driven_.push_back({node, nullptr, path});
  } else if (moving != nullptr) {
    require_that(walls.empty() && !level_at(*walls.front(), label(node)),
                 "a moving wall meets a wall that is not level at ({:g}, {:g}); allowed: a level bottom there",
                 mesh.x[node], mesh.y[node]);
    wx_[node] = 0;
    if (!walls.empty()) wy_[node] = 0;
    driven_.push_back({node, moving, nullptr});
  } else if (walls.size() == 2 && !joined(*sides[0], *sides[1])) {
    wx_[node] = wy_[node] = 0;
  } else if (!walls.empty()) {
    if (vertical(*walls.front())) {
      wx_[node] = 0;
    } else if (level(*walls.front())) {
      wy_[node] = 0;
    } else {
      const Curve& curve = *walls.front()->curve;
      wx_[node] = wy_[node] = 0;
      slides_.push_back({.node = node, .curve = &curve, .direction = curve.tangent(curve.arc_length_at(label(node)))});
    }
  }
}

Point Nodes::driven_place(const Driven& node, double time) const {
  if (node.path != nullptr) return node.path->position(label(node.node), time);
  return {node.wall->place(time), label(node.node).y};
}

Point Nodes::driven_velocity(const Driven& node, double time) const {
  if (node.path != nullptr) return node.path->velocity(label(node.node), time);
  return {node.wall->velocity(time), 0};
}

Point Nodes::driven_rate(const Driven& node, mechanics::Interval when) const {
  if (when.length == 0) return driven_velocity(node, when.begin);
  const Point begin = driven_place(node, when.begin);
  const Point end = driven_place(node, when.end());
  return {(end.x - begin.x) / when.length, (end.y - begin.y) / when.length};
}

}  // namespace seiche::lagrangian_mesh_2d
