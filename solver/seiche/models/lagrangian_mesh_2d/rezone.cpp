#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/plan_lattice/swept_remap.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

namespace {

/// Passes over the surface in which its edges give back what they swept. More of them would raise waves of two edges.
constexpr int local_passes = 4;
/// Passes in which the whole surface does: over inclined columns what is lacking is squared by each.
constexpr int whole_passes = 3;
// Of the search for a column's place; its water changes nearly linearly with it.
constexpr int most_iterations = 20;
constexpr double settled = 1e-13;  // of the column's height

void require_straight_wall(std::string_view name, const Side& side) {
  const auto* wall = std::get_if<Wall>(&side);
  require_that(wall != nullptr && std::dynamic_pointer_cast<const Line>(wall->curve),
               "the {} side of a rezoned mesh is not a straight wall; allowed: a straight wall", name);
}

/// Signed area between two surface edges with ends a, b before and c, d after.
double area_between(Point a, Point b, Point c, Point d) {
  return 0.5 * ((d.x - a.x) * (c.y - b.y) - (c.x - b.x) * (d.y - a.y));
}

}  // namespace

UprightColumns::UprightColumns(const Mesh& first) : shape_(first) {
  require_straight_wall("left", first.sides.left);
  require_straight_wall("right", first.sides.right);
  require_that(std::holds_alternative<Wall>(first.sides.bottom) && std::holds_alternative<FreeSide>(first.sides.top) &&
                   !joined(first.sides.left, first.sides.bottom) && !joined(first.sides.bottom, first.sides.right),
               "a rezoned mesh is not a layer between walls; allowed: a bottom that neither wall goes "
               "on into, under a free surface");
  require_at_least("columns", static_cast<long>(shape_.columns), 3);
  require_at_least("rows", static_cast<long>(shape_.rows), 3);
  bottom_ = std::get<Wall>(first.sides.bottom).curve;
  part_.resize(shape_.nodes());
  for (std::size_t i = 0; i <= shape_.columns; ++i) {
    const std::size_t low = shape_.node(i, 0);
    const std::size_t high = shape_.node(i, shape_.rows);
    const double height = first.y[high] - first.y[low];
    direction_.push_back({(first.x[high] - first.x[low]) / height, 1});
    for (std::size_t j = 0; j <= shape_.rows; ++j) {
      const std::size_t k = shape_.node(i, j);
      part_[k] = (first.y[k] - first.y[low]) / height;
    }
  }
}

/// Every edge of the new surface that has swept too much water gives it back: its ends go down for half of it each. The
/// rounded rest the whole surface gives.
void UprightColumns::level(mechanics::Input q, std::vector<Point>& top) const {
  const std::size_t last = shape_.columns;
  const auto surface = [&](std::size_t i) { return old(q, i, shape_.rows); };
  std::vector<double> gained(last);     // by edges
  std::vector<double> width(last + 1);  // twice the change of the area with the rise of a node along its column
  for (int pass = 0; pass < local_passes + whole_passes; ++pass) {
    CompensatedSum all;
    for (std::size_t i = 0; i < last; ++i) {
      gained[i] = area_between(surface(i), surface(i + 1), top[i], top[i + 1]);
      all.add(gained[i]);
    }
    CompensatedSum widths;
    for (std::size_t i = 0; i <= last; ++i) {
      const Point before = top[i > 0 ? i - 1 : i];
      const Point after = top[i < last ? i + 1 : i];
      width[i] = (after.x - before.x) - direction_[i].x * (after.y - before.y);
      widths.add(width[i]);
    }
    for (std::size_t i = 0; i <= last; ++i) {
      const double around = (i > 0 ? gained[i - 1] : 0.0) + (i < last ? gained[i] : 0.0);
      top[i] += (pass < local_passes ? -around / width[i] : -2 * all.value() / widths.value()) * direction_[i];
    }
  }
}

Point UprightColumns::foot(mechanics::Input q, const plan_lattice::RowCurve& surface, std::size_t i, Point& top) const {
  const auto node = [&](std::size_t j) { return old(q, i, j); };
  double s = bottom_->arc_length_at(node(0));
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Point low = bottom_->position(s);
    top = surface.meet(i, low, low + direction_[i]);
    // What the column sweeps to its right on its way from the old nodes to the line.
    double swept = 0;
    for (std::size_t j = 0; j < shape_.rows; ++j) swept -= 0.5 * cross(node(j), node(j + 1));
    swept -= 0.5 * (cross(node(shape_.rows), top) + cross(top, low) + cross(low, node(0)));
    const double height = top.y - low.y;
    const double step = -swept / height;
    s += step;
    if (std::abs(step) < settled * height) break;
  }
  return bottom_->position(s);
}

UprightColumns::Places UprightColumns::places(mechanics::Input q) const {
  const std::size_t n = shape_.nodes();
  const std::size_t count = shape_.columns + 1;
  const std::size_t surface = shape_.node(0, shape_.rows);
  const plan_lattice::RowCurve curve(q.subspan(surface, count), q.subspan(n + surface, count));
  std::vector<Point> low;
  std::vector<Point> top;
  for (std::size_t i = 0; i < count; ++i) {
    low.push_back({q[i], q[n + i]});
    top.push_back(curve.at(static_cast<double>(i)));
    if (i != 0 && i != shape_.columns) low[i] = foot(q, curve, i, top[i]);
  }
  level(q, top);
  Places places{.x = std::vector<double>(n), .y = std::vector<double>(n)};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= shape_.rows; ++j) {
      const std::size_t k = shape_.node(i, j);
      places.put(k, {std::lerp(low[i].x, top[i].x, part_[k]), std::lerp(low[i].y, top[i].y, part_[k])});
    }
  }
  return places;
}

Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y) {
  const Mesh& was = model.mesh();
  const std::size_t n = was.nodes();
  Remapped now{.mesh = was, .velocity = {}};
  now.mesh.x = std::move(x);
  now.mesh.y = std::move(y);
  plan_lattice::require_convex(was, now.mesh.x, now.mesh.y);
  const plan_lattice::SweptRemap sweep(was, q.first(n), q.subspan(n, n), now.mesh.x, now.mesh.y,
                                       std::vector<double>(n, 0.25));
  const auto velocity_at = [&](const plan_lattice::LatticePlace& place) {
    return Point{sweep.old().value(u.first(n), place), sweep.old().value(u.subspan(n, n), place)};
  };
  for (std::size_t k = 0; k < n; ++k) now.velocity.push_back(velocity_at(sweep.place(k)));
  // Momenta per density: those of the old cells, and what edges sweep.
  std::vector<double> area;
  std::vector<Point> momentum;
  for (std::size_t cell = 0; cell < was.cells(); ++cell) {
    area.push_back(cell_area(now.mesh, now.mesh.x, now.mesh.y, cell));
    momentum.push_back(cell_area(was, q.first(n), q.subspan(n, n), cell) * sweep.mean(cell, [&](std::size_t k) {
      return Point{u[k], u[n + k]};
    }));
  }
  was.each_edge([&](std::size_t p, std::size_t r, std::size_t into, std::size_t from) {
    Point through;
    sweep.each_swept(p, r, [&](const SweptPoint& point, const plan_lattice::LatticePlace& place) {
      through += point.area * velocity_at(place);
    });
    if (into != was.outside) momentum[into] += through;
    if (from != was.outside) momentum[from] = momentum[from] - through;
  });
  const auto lacking = sweep.lacking(area, momentum, [&](std::size_t k) { return now.velocity[k]; });
  for (std::size_t k = 0; k < n; ++k) now.velocity[k] += lacking[k];
  return now;
}

}  // namespace seiche::lagrangian_mesh_2d
