#include "seiche/models/lagrangian_mesh_2d/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/lattice/water.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

/// Of a straight wall; of a curve one that is along no axis.
Point direction(const Wall& wall) {
  const auto* line = dynamic_cast<const Line*>(wall.curve.get());
  return line != nullptr ? line->tangent(0) : Point{1, 1};
}

/// Level and unbent to rounding: a node that is driven along x does not leave the curve then.
bool level_at(const Wall& wall, Point place) {
  const double s = wall.curve->arc_length_at(place);
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  return std::abs(wall.curve->tangent(s).y) <= rounding && std::abs(wall.curve->curvature(s).y) <= rounding;
}

}  // namespace

Nodes::Nodes(const Mesh& mesh, std::span<const double> areas, double density, bool tuned_surface_inertia)
    : sides_(std::make_shared<const Sides>(mesh.sides)), mass_(mesh.nodes(), 0.0) {
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
  const auto walks = plan_lattice::nodes_around(mesh);
  const std::array sides{&sides_->bottom, &sides_->right, &sides_->top, &sides_->left};
  for (std::size_t s = 0; s < walks.size(); ++s) {
    for (std::size_t k = 1; k + 1 < walks[s].size(); ++k) hold(mesh, walks[s][k], {sides[s]});
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
  require_that(!contact || direction(*wall).y != 0,
               "the free side ends at a level wall, at ({:g}, {:g}); allowed: walls with a slope", mesh.x[node],
               mesh.y[node]);
  hold(mesh, node, {&beside, &across});
  if (contact && !slides_.empty() && slides_.back().node == node) {
    // Pi = ... + W at the left end of the surface, - W at its right end; reversed at a free bottom.
    slides_.back().contact_sign = (i == 0) == (j != 0) ? 1 : -1;
  }
}

void Nodes::hold(const Mesh& mesh, std::size_t node, const std::vector<const Side*>& sides) {
  const Point first{mesh.x[node], mesh.y[node]};
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
    driven_.push_back({node, true, [path, first](double time) { return path->position(first, time); },
                       [path, first](double time) { return path->velocity(first, time); }});
  } else if (moving != nullptr) {
    require_that(walls.empty() || level_at(*walls.front(), first),
                 "a moving wall meets a wall that is not level at ({:g}, {:g}); allowed: a level bottom there", first.x,
                 first.y);
    wx_[node] = 0;
    if (!walls.empty()) wy_[node] = 0;
    const auto level_with = [](const std::function<double(double)>* along, double y) {
      return [along, y](double time) { return Point{(*along)(time), y}; };
    };
    driven_.push_back({node, false, level_with(&moving->place, first.y), level_with(&moving->velocity, 0)});
  } else if (walls.size() == 2 && !joined(*sides[0], *sides[1])) {
    wx_[node] = wy_[node] = 0;
  } else if (!walls.empty()) {
    if (direction(*walls.front()).x == 0) {
      wx_[node] = 0;
    } else if (direction(*walls.front()).y == 0) {
      wy_[node] = 0;
    } else {
      const Curve& curve = *walls.front()->curve;
      wx_[node] = wy_[node] = 0;
      slides_.push_back({.node = node, .curve = &curve, .direction = curve.tangent(curve.arc_length_at(first))});
    }
  }
}

Point Driven::rate(mechanics::Interval when) const {
  if (when.length == 0) return velocity(when.begin);
  const Point way = place(when.end()) - place(when.begin);
  return {way.x / when.length, way.y / when.length};
}

void Driven::put(Point value, Output values, std::size_t nodes) const {
  values[node] = value.x;
  if (both) values[nodes + node] = value.y;
}

FreeEdges::FreeEdges(const Mesh& mesh) : n_(mesh.nodes()) {
  const auto free = [](const Side& side) { return std::holds_alternative<FreeSide>(side); };
  const bool top_only = !free(mesh.sides.left) && !free(mesh.sides.right) && !free(mesh.sides.bottom);
  first_node_ = top_only ? mesh.node(0, mesh.rows) : 0;
  // Clockwise around the water, from the top on.
  const auto walks = plan_lattice::nodes_around(mesh);
  const std::array sides{&mesh.sides.bottom, &mesh.sides.right, &mesh.sides.top, &mesh.sides.left};
  for (const std::size_t s : {2, 1, 0, 3}) {
    for (std::size_t k = walks[s].size() - 1; free(*sides[s]) && k > 0; --k) {
      edges_.push_back({walks[s][k], walks[s][k - 1]});
    }
  }
}

double FreeEdges::moment(Input q) const {
  double sum = 0;
  for (const auto [a, b] : edges_) {
    const double ya = q[n_ + a];
    const double yb = q[n_ + b];
    sum += (q[b] - q[a]) * (ya * ya + ya * yb + yb * yb) / 6;
  }
  return sum;
}

void FreeEdges::push_down(Input q, double weight, Output push) const {
  const double sixth = weight / 6;
  for (const auto [a, b] : edges_) {
    const double ya = q[n_ + a];
    const double yb = q[n_ + b];
    const double square = sixth * (ya * ya + ya * yb + yb * yb);
    const double width = sixth * (q[b] - q[a]);
    add_point({square, -width * (2 * ya + yb)}, push, n_, a);
    add_point({-square, -width * (ya + 2 * yb)}, push, n_, b);
  }
}

void FreeEdges::press(const std::function<double(double)>& pressure, Input q, double weight, Output push) const {
  for (const auto [a, b] : edges_) {
    const Point way = point_at(q, n_, b) - point_at(q, n_, a);
    const double half = 0.5 * weight * pressure(0.5 * (q[a] + q[b]));
    for (const std::size_t end : {a, b}) add_point({half * way.y, -half * way.x}, push, n_, end);
  }
}

namespace {

constexpr double onset = 0.3;

/// visit(nodes of the corner, of the next and the previous one, counter-clockwise, its shape, its cell) for every
/// corner below the onset.
template <class Visit>
void over_sharp_corners(const Mesh& mesh, Input first_areas, Input q, const Visit& visit) {
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto r = mesh.corners(cell);
    for (std::size_t c = 0; c < 4; ++c) {
      const std::array k{r[c], r[(c + 1) % 4], r[(c + 3) % 4]};
      const Point own = point_at(q, mesh.nodes(), k[0]);
      const Point next = point_at(q, mesh.nodes(), k[1]) - own;
      const Point previous = point_at(q, mesh.nodes(), k[2]) - own;
      const double shape = cross(next, previous) / first_areas[cell];
      if (shape < onset) visit(k, next, previous, shape, first_areas[cell]);
    }
  }
}

}  // namespace

double CornerBarrier::energy(const Mesh& mesh, Input first_areas, Input q) const {
  double sum = 0;
  over_sharp_corners(mesh, first_areas, q, [&](const auto&, Point, Point, double shape, double area) {
    const double excess = onset / shape - 1;
    sum += shape > 0 ? std::pow(area, 1.5) * excess * excess : std::numeric_limits<double>::infinity();
  });
  return stiffness_ * sum;
}

void CornerBarrier::push(const Mesh& mesh, Input first_areas, Input q, double weight, Output push) const {
  const std::size_t n = mesh.nodes();
  over_sharp_corners(mesh, first_areas, q, [&](const auto& k, Point next, Point previous, double shape, double area) {
    // -dPi/d(twice the triangle).
    const double force = weight * stiffness_ * std::sqrt(area) * 2 * (onset / shape - 1) * onset / (shape * shape);
    const Point on_next = force * Point{previous.y, -previous.x};
    const Point on_previous = force * Point{-next.y, next.x};
    add_point(on_next, push, n, k[1]);
    add_point(on_previous, push, n, k[2]);
    add_point(-1 * (on_next + on_previous), push, n, k[0]);
  });
}

namespace {

Point alternating(const Mesh& mesh, Input q, std::size_t cell) {
  const auto [r0, r1, r2, r3] = mesh.corners(cell);
  const std::size_t n = mesh.nodes();
  return point_at(q, n, r0) - point_at(q, n, r1) + point_at(q, n, r2) - point_at(q, n, r3);
}

}  // namespace

Hourglass::Hourglass(const Mesh& mesh, double stiffness) : stiffness_(stiffness) {
  const std::vector<double> q = lattice::joined({mesh.x, mesh.y});
  for (std::size_t cell = 0; active() && cell < mesh.cells(); ++cell) rest_.push_back(alternating(mesh, q, cell));
}

double Hourglass::energy(const Mesh& mesh, Input q) const {
  double squares = 0;
  for (std::size_t cell = 0; cell < rest_.size(); ++cell) {
    const Point off = alternating(mesh, q, cell) - rest_[cell];
    squares += dot(off, off);
  }
  return 0.5 * stiffness_ * squares;
}

void Hourglass::push(const Mesh& mesh, Input q, double weight, Output push) const {
  for (std::size_t cell = 0; cell < rest_.size(); ++cell) {
    const Point off = alternating(mesh, q, cell) - rest_[cell];
    const auto r = mesh.corners(cell);
    for (std::size_t c = 0; c < 4; ++c) {
      add_point((c % 2 == 0 ? -weight : weight) * stiffness_ * off, push, mesh.nodes(), r[c]);
    }
  }
}

}  // namespace seiche::lagrangian_mesh_2d
