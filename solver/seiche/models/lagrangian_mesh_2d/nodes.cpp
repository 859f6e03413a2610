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
    require_that(walls.empty() || level_at(*walls.front(), label(node)),
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

FreeEdges::FreeEdges(const Mesh& mesh) {
  const auto free = [](const Side& side) { return std::holds_alternative<FreeSide>(side); };
  const auto row = static_cast<std::ptrdiff_t>(mesh.columns + 1);
  const auto last = static_cast<std::ptrdiff_t>(mesh.nodes() - 1);
  const auto right = static_cast<std::ptrdiff_t>(mesh.columns);
  const bool top_only = !free(mesh.sides.left) && !free(mesh.sides.right) && !free(mesh.sides.bottom);
  first_node_ = top_only ? mesh.node(0, mesh.rows) : 0;
  // Clockwise around the water.
  if (free(mesh.sides.top)) strips_.push_back({last - right, 1, mesh.columns});
  if (free(mesh.sides.right)) strips_.push_back({last, -row, mesh.rows});
  if (free(mesh.sides.bottom)) strips_.push_back({right, -1, mesh.columns});
  if (free(mesh.sides.left)) strips_.push_back({0, row, mesh.rows});
}

double FreeEdges::moment(const double* x, const double* y) const {
  double sum = 0;
  over_edges([&](std::ptrdiff_t a, std::ptrdiff_t b) {
    sum += (x[b] - x[a]) * (y[a] * y[a] + y[a] * y[b] + y[b] * y[b]) / 6;
  });
  return sum;
}

void FreeEdges::push_down(const double* x, const double* y, double weight, double* push_x, double* push_y) const {
  const double sixth = weight / 6;
  over_edges([&](std::ptrdiff_t a, std::ptrdiff_t b) {
    const double square = sixth * (y[a] * y[a] + y[a] * y[b] + y[b] * y[b]);
    const double width = sixth * (x[b] - x[a]);
    push_x[a] += square;
    push_x[b] -= square;
    push_y[a] -= width * (2 * y[a] + y[b]);
    push_y[b] -= width * (y[a] + 2 * y[b]);
  });
}

void FreeEdges::press(const std::function<double(double)>& pressure, const double* x, const double* y, double weight,
                      double* push_x, double* push_y) const {
  over_edges([&](std::ptrdiff_t a, std::ptrdiff_t b) {
    const double half = 0.5 * weight * pressure(0.5 * (x[a] + x[b]));
    const double dx = half * (x[b] - x[a]);
    const double dy = half * (y[b] - y[a]);
    push_x[a] += dy;
    push_x[b] += dy;
    push_y[a] -= dx;
    push_y[b] -= dx;
  });
}

namespace {

constexpr double onset = 0.3;

struct CornerNodes {
  std::size_t own, next, previous;  // counter-clockwise: next after own, previous before
};

/// visit(corner's nodes, its shape, its cell) for every corner below the onset.
template <class Visit>
void over_sharp_corners(const Mesh& mesh, std::span<const double> first_areas, const double* x, const double* y,
                        const Visit& visit) {
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto r = mesh.corners(cell);
    for (std::size_t c = 0; c < 4; ++c) {
      const CornerNodes k{r[c], r[(c + 1) % 4], r[(c + 3) % 4]};
      const double twice_triangle =
          (x[k.next] - x[k.own]) * (y[k.previous] - y[k.own]) - (y[k.next] - y[k.own]) * (x[k.previous] - x[k.own]);
      const double shape = twice_triangle / first_areas[cell];
      if (shape < onset) visit(k, shape, cell);
    }
  }
}

}  // namespace

double CornerBarrier::energy(const Mesh& mesh, std::span<const double> first_areas, const double* x,
                             const double* y) const {
  double sum = 0;
  over_sharp_corners(mesh, first_areas, x, y, [&](const CornerNodes&, double shape, std::size_t cell) {
    const double excess = onset / shape - 1;
    sum += shape > 0 ? std::pow(first_areas[cell], 1.5) * excess * excess : std::numeric_limits<double>::infinity();
  });
  return stiffness_ * sum;
}

void CornerBarrier::push(const Mesh& mesh, std::span<const double> first_areas, const double* x, const double* y,
                         double weight, std::span<double> push_x, std::span<double> push_y) const {
  over_sharp_corners(mesh, first_areas, x, y, [&](const CornerNodes& k, double shape, std::size_t cell) {
    // -dPi/d(twice the triangle).
    const double force =
        weight * stiffness_ * std::sqrt(first_areas[cell]) * 2 * (onset / shape - 1) * onset / (shape * shape);
    const double next_x = force * (y[k.previous] - y[k.own]);
    const double next_y = -force * (x[k.previous] - x[k.own]);
    const double previous_x = -force * (y[k.next] - y[k.own]);
    const double previous_y = force * (x[k.next] - x[k.own]);
    push_x[k.next] += next_x;
    push_y[k.next] += next_y;
    push_x[k.previous] += previous_x;
    push_y[k.previous] += previous_y;
    push_x[k.own] -= next_x + previous_x;
    push_y[k.own] -= next_y + previous_y;
  });
}

namespace {

Point alternating(const Mesh& mesh, const double* x, const double* y, std::size_t cell) {
  const auto [r0, r1, r2, r3] = mesh.corners(cell);
  return {x[r0] - x[r1] + x[r2] - x[r3], y[r0] - y[r1] + y[r2] - y[r3]};
}

}  // namespace

Hourglass::Hourglass(const Mesh& mesh, double stiffness) : stiffness_(stiffness) {
  for (std::size_t cell = 0; active() && cell < mesh.cells(); ++cell) {
    rest_.push_back(alternating(mesh, mesh.x.data(), mesh.y.data(), cell));
  }
}

double Hourglass::energy(const Mesh& mesh, const double* x, const double* y) const {
  double squares = 0;
  for (std::size_t cell = 0; cell < rest_.size(); ++cell) {
    const Point h = alternating(mesh, x, y, cell);
    const Point off{h.x - rest_[cell].x, h.y - rest_[cell].y};
    squares += dot(off, off);
  }
  return 0.5 * stiffness_ * squares;
}

void Hourglass::push(const Mesh& mesh, const double* x, const double* y, double weight, double* push_x,
                     double* push_y) const {
  for (std::size_t cell = 0; cell < rest_.size(); ++cell) {
    const Point h = alternating(mesh, x, y, cell);
    const auto r = mesh.corners(cell);
    for (std::size_t c = 0; c < 4; ++c) {
      const double towards = (c % 2 == 0 ? -weight : weight) * stiffness_;
      push_x[r[c]] += towards * (h.x - rest_[cell].x);
      push_y[r[c]] += towards * (h.y - rest_[cell].y);
    }
  }
}

}  // namespace seiche::lagrangian_mesh_2d
