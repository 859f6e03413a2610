#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/swept_quadrilateral.hpp"
#include "seiche/plan_lattice/lattice_interpolant.hpp"
#include "seiche/require.hpp"

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
  if (wall != nullptr && std::dynamic_pointer_cast<const Line>(wall->curve)) return;
  throw std::invalid_argument(
      fmt::format("the {} side of a rezoned mesh is not a straight wall; allowed: a straight wall", name));
}

/// Signed area between two surface edges with ends a, b before and c, d after.
double area_between(Point a, Point b, Point c, Point d) {
  return 0.5 * ((d.x - a.x) * (c.y - b.y) - (c.x - b.x) * (d.y - a.y));
}

}  // namespace

UprightColumns::UprightColumns(const Mesh& first) : shape_{.columns = first.columns, .rows = first.rows} {
  require_straight_wall("left", first.sides.left);
  require_straight_wall("right", first.sides.right);
  if (!std::holds_alternative<Wall>(first.sides.bottom) || !std::holds_alternative<FreeSide>(first.sides.top) ||
      first.has_joined_sides()) {
    throw std::invalid_argument(
        "a rezoned mesh is not a layer between walls; allowed: a bottom that neither wall goes "
        "on into, under a free surface");
  }
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
  const std::size_t n = shape_.nodes();
  const auto old = [&](std::size_t i) {
    const std::size_t k = shape_.node(i, shape_.rows);
    return Point{q[k], q[n + k]};
  };
  std::vector<double> gained(last);     // by edges
  std::vector<double> width(last + 1);  // twice the change of the area with the rise of a node along its column
  for (int pass = 0; pass < local_passes + whole_passes; ++pass) {
    CompensatedSum all;
    for (std::size_t i = 0; i < last; ++i) {
      gained[i] = area_between(old(i), old(i + 1), top[i], top[i + 1]);
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
      const double rise = pass < local_passes ? -around / width[i] : -2 * all.value() / widths.value();
      top[i].x += rise * direction_[i].x;
      top[i].y += rise;
    }
  }
}

Point UprightColumns::foot(mechanics::Input q, const plan_lattice::RowCurve& surface, std::size_t i, Point& top) const {
  const std::size_t n = shape_.nodes();
  const auto old = [&](std::size_t j) {
    const std::size_t k = shape_.node(i, j);
    return Point{q[k], q[n + k]};
  };
  double s = bottom_->arc_length_at(old(0));
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Point low = bottom_->position(s);
    top = surface.meet(i, low, {low.x + direction_[i].x, low.y + direction_[i].y});
    // What the column sweeps to its right on its way from the old nodes to the line.
    double swept = 0;
    for (std::size_t j = 0; j < shape_.rows; ++j) swept -= 0.5 * cross(old(j), old(j + 1));
    swept -= 0.5 * (cross(old(shape_.rows), top) + cross(top, low) + cross(low, old(0)));
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
      places.x[k] = std::lerp(low[i].x, top[i].x, part_[k]);
      places.y[k] = std::lerp(low[i].y, top[i].y, part_[k]);
    }
  }
  return places;
}

double UprightColumns::drift(mechanics::Input q, const Places& places) const {
  const std::size_t n = shape_.nodes();
  return plan_lattice::farthest(shape_, q.first(n), q.subspan(n, n), places);
}

namespace {

using plan_lattice::LatticePlace;

class Remap {
 public:
  Remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y)
      : n_(model.mesh().nodes()),
        q_(q),
        u_(u),
        was_(model.mesh()),
        old_({.columns = was_.columns, .rows = was_.rows}, q.first(n_), q.subspan(n_, n_)) {
    now_.mesh = was_;
    now_.mesh.x = std::move(x);
    now_.mesh.y = std::move(y);
  }

  Remapped run() {
    require_unfolded();
    interpolate();
    sweep();
    level_momentum();
    return std::move(now_);
  }

 private:
  [[nodiscard]] Point old_point(std::size_t k) const { return {q_[k], q_[n_ + k]}; }
  [[nodiscard]] Point new_point(std::size_t k) const { return {now_.mesh.x[k], now_.mesh.y[k]}; }
  [[nodiscard]] Point velocity_at(const LatticePlace& place) const {
    return {old_.value(u_.first(n_), place), old_.value(u_.subspan(n_, n_), place)};
  }
  [[nodiscard]] double old_area(std::size_t cell) const {
    return cell_area(was_, q_.first(n_), q_.subspan(n_, n_), cell);
  }
  [[nodiscard]] double new_area(std::size_t cell) const { return cell_area(now_.mesh, now_.mesh.x, now_.mesh.y, cell); }

  void require_unfolded() const {
    for (std::size_t cell = 0; cell < was_.cells(); ++cell) {
      if (new_area(cell) > 0 && least_triangle(now_.mesh, now_.mesh.x, now_.mesh.y, cell) > 0) continue;
      const Point corner = new_point(was_.corners(cell)[0]);
      throw mechanics::Infeasible(fmt::format("cell {} at ({:g}, {:g}) would fold", cell, corner.x, corner.y),
                                  corner.x);
    }
  }

  void interpolate() {
    for (std::size_t j = 0; j <= was_.rows; ++j) {
      for (std::size_t i = 0; i <= was_.columns; ++i) {
        const LatticePlace guess{.i = static_cast<double>(i), .j = static_cast<double>(j)};
        now_.velocity.push_back(velocity_at(old_.find(new_point(was_.node(i, j)), guess)));
      }
    }
  }

  /// Momentum per density that the edge p -> q sweeps towards its right.
  [[nodiscard]] Point swept(std::size_t p, std::size_t q, LatticePlace guess) const {
    Point momentum;
    each_swept_point({old_point(p), new_point(p), new_point(q), old_point(q)}, [&](const SweptPoint& point) {
      const Point velocity = velocity_at(old_.find(point.place, guess));
      momentum.x += point.area * velocity.x;
      momentum.y += point.area * velocity.y;
    });
    return momentum;
  }

  void sweep() {
    gained_.assign(was_.cells(), {});
    const auto add = [&](std::size_t cell, double sign, Point momentum) {
      gained_[cell].x += sign * momentum.x;
      gained_[cell].y += sign * momentum.y;
    };
    for (std::size_t j = 0; j <= was_.rows; ++j) {
      for (std::size_t i = 0; i < was_.columns; ++i) {
        const LatticePlace guess{.i = static_cast<double>(i) + 0.5, .j = static_cast<double>(j)};
        const Point through = swept(was_.node(i, j), was_.node(i + 1, j), guess);
        if (j < was_.rows) add(j * was_.columns + i, 1, through);
        if (j > 0) add((j - 1) * was_.columns + i, -1, through);
      }
    }
    for (std::size_t j = 0; j < was_.rows; ++j) {
      for (std::size_t i = 0; i <= was_.columns; ++i) {
        const LatticePlace guess{.i = static_cast<double>(i), .j = static_cast<double>(j) + 0.5};
        const Point through = swept(was_.node(i, j), was_.node(i, j + 1), guess);
        if (i > 0) add(j * was_.columns + i - 1, 1, through);
        if (i < was_.columns) add(j * was_.columns + i, -1, through);
      }
    }
  }

  void level_momentum() {
    std::vector<double> mass(n_, 0.0);
    for (std::size_t cell = 0; cell < was_.cells(); ++cell) {
      for (const std::size_t k : was_.corners(cell)) mass[k] += 0.25 * new_area(cell);
    }
    std::vector<Point> change(n_);
    for (std::size_t cell = 0; cell < was_.cells(); ++cell) {
      const auto corners = was_.corners(cell);
      Point before{};
      Point now{};
      for (const std::size_t k : corners) {
        before.x += u_[k] / 4;
        before.y += u_[n_ + k] / 4;
        now.x += now_.velocity[k].x / 4;
        now.y += now_.velocity[k].y / 4;
      }
      const double was = old_area(cell);
      const double is = new_area(cell);
      const Point lacking{was * before.x + gained_[cell].x - is * now.x, was * before.y + gained_[cell].y - is * now.y};
      for (const std::size_t k : corners) {
        change[k].x += lacking.x / (4 * mass[k]);
        change[k].y += lacking.y / (4 * mass[k]);
      }
    }
    for (std::size_t k = 0; k < n_; ++k) {
      now_.velocity[k].x += change[k].x;
      now_.velocity[k].y += change[k].y;
    }
  }

  std::size_t n_;
  Input q_, u_;
  const Mesh& was_;
  plan_lattice::LatticeInterpolant old_;
  Remapped now_;
  std::vector<Point> gained_;  // momentum per density
};

}  // namespace

Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y) {
  return Remap(model, q, u, std::move(x), std::move(y)).run();
}

}  // namespace seiche::lagrangian_mesh_2d
