#include "seiche/models/lagrangian_mesh_2d/remap.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "seiche/geometry/swept_quadrilateral.hpp"
#include "seiche/plan_lattice/lattice_interpolant.hpp"

namespace seiche::lagrangian_mesh_2d {

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
    std::vector<double> area(was_.cells());
    for (std::size_t cell = 0; cell < was_.cells(); ++cell) area[cell] = new_area(cell);
    const Corner worst = worst_corner(now_.mesh, now_.mesh.x, now_.mesh.y, area);
    // A negative area turns the sign of the shape.
    for (std::size_t cell = 0; cell < was_.cells(); ++cell) {
      if (area[cell] > 0 && (worst.cell != cell || worst.shape > 0)) continue;
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
