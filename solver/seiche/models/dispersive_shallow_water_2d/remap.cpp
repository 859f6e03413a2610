#include "seiche/models/dispersive_shallow_water_2d/remap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/plan_lattice/lattice_interpolant.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

using plan_lattice::LatticeInterpolant;
using plan_lattice::LatticePlace;

using bilinear_patch::Corners;

/// What passes through an edge or is in a cell.
struct Content {
  double level = 0;  ///< int z dA
  double water = 0;  ///< int H dA
  Point momentum{};  ///< int H u dA
};

class Remap {
 public:
  Remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y)
      : model_(model),
        shape_(model.shape()),
        n_(shape_.nodes()),
        q_(q),
        u_(u),
        old_(shape_, q.first(n_), q.subspan(n_, n_)),
        on_shore_(n_, 0),
        quadrilateral_({1, 1}, model.lattice().bottom) {
    now_.lattice = model.lattice();
    now_.lattice.x = std::move(x);
    now_.lattice.y = std::move(y);
    for (const auto& edge : plan_lattice::shore_edges(shape_, now_.lattice.sides)) {
      for (const std::size_t k : edge) on_shore_[k] = 1;
    }
    for (std::size_t k = 0; k < n_; ++k)
      depth_.push_back(on_shore_[k] != 0 ? 0 : q_[2 * n_ + k] - bottom(old_point(k)));
  }

  Remapped run() {
    require_convex();
    find_nodes();
    interpolate();
    sweep();
    level_water();
    level_momentum();
    return std::move(now_);
  }

 private:
  [[nodiscard]] std::span<const double> old_values(std::size_t axis) const { return u_.subspan(axis * n_, n_); }
  [[nodiscard]] Point old_point(std::size_t k) const { return {q_[k], q_[n_ + k]}; }
  [[nodiscard]] Point new_point(std::size_t k) const { return {now_.lattice.x[k], now_.lattice.y[k]}; }
  [[nodiscard]] double bottom(Point at) const {
    const Lattice& lattice = now_.lattice;
    return lattice.bottom ? lattice.bottom->slope(at.x, at.y).elevation : -lattice.depth;
  }

  /// Depth of the old surface: the cubic one's, as long as the bilinear one is near it. In a thin sheet the cubic one
  /// would go below the bottom.
  [[nodiscard]] double old_depth(Point at, const LatticePlace& found) const {
    const double linear = old_.linear_value(depth_, found);
    return std::clamp(old_.value(q_.subspan(2 * n_, n_), found) - bottom(at), linear / 2, 2 * linear);
  }

  /// int b dA of the quadrilateral, by the rule of the model's volumes.
  [[nodiscard]] double bottom_under(const std::array<Point, 4>& at) const {
    const std::array x{at[0].x, at[1].x, at[3].x, at[2].x};
    const std::array y{at[0].y, at[1].y, at[3].y, at[2].y};
    if (now_.lattice.bottom) return quadrilateral_.volume({x.data(), y.data()}, 0);
    const auto j =
        bilinear_patch::jacobians({at[0].x, at[1].x, at[2].x, at[3].x}, {at[0].y, at[1].y, at[2].y, at[3].y});
    return -now_.lattice.depth * 0.5 * (j.c0 + j.c2);
  }

  void require_convex() const {
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto at = corners_of(cell, true);
      const auto j =
          bilinear_patch::jacobians({at[0].x, at[1].x, at[2].x, at[3].x}, {at[0].y, at[1].y, at[2].y, at[3].y});
      if (std::min(std::min(j.c0, j.c1), std::min(j.c2, j.c3)) > 0) continue;
      throw mechanics::Infeasible(fmt::format("cell {} at ({:g}, {:g}) would fold", cell, at[0].x, at[0].y), at[0].x);
    }
  }

  void find_nodes() {
    for (std::size_t j = 0; j <= shape_.rows; ++j) {
      for (std::size_t i = 0; i <= shape_.columns; ++i) {
        LatticePlace guess{.i = static_cast<double>(i), .j = static_cast<double>(j)};
        places_.push_back(old_.find(new_point(shape_.node(i, j)), guess));
      }
    }
  }

  void interpolate() {
    now_.u.resize(n_);
    now_.v.resize(n_);
    now_.w.resize(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      const Point at = new_point(k);
      now_.lattice.z[k] = bottom(at) + (on_shore_[k] != 0 ? 0.0 : old_depth(at, places_[k]));
      now_.u[k] = old_.value(old_values(0), places_[k]);
      now_.v[k] = old_.value(old_values(1), places_[k]);
      now_.w[k] = old_.value(old_values(2), places_[k]);
    }
  }

  /// What the edge p -> q sweeps towards its right.
  [[nodiscard]] Content swept(std::size_t p, std::size_t q, LatticePlace guess, bool closed) const {
    const std::array at{old_point(p), new_point(p), new_point(q), old_point(q)};
    Content through;
    const double under = bottom_under(at);
    if (closed) {
      through.level = under;
      return through;
    }
    static const double gauss = 0.5 / std::numbers::sqrt3;
    for (const double s : {0.5 - gauss, 0.5 + gauss}) {
      for (const double t : {0.5 - gauss, 0.5 + gauss}) {
        const auto mix = [&](auto part) {
          return (1 - t) * ((1 - s) * part(at[0]) + s * part(at[1])) + t * ((1 - s) * part(at[3]) + s * part(at[2]));
        };
        const auto by_s = [&](auto part) {
          return (1 - t) * (part(at[1]) - part(at[0])) + t * (part(at[2]) - part(at[3]));
        };
        const auto by_t = [&](auto part) {
          return (1 - s) * (part(at[3]) - part(at[0])) + s * (part(at[2]) - part(at[1]));
        };
        const auto x = [](Point a) { return a.x; };
        const auto y = [](Point a) { return a.y; };
        const double area = 0.25 * (by_s(x) * by_t(y) - by_s(y) * by_t(x));
        if (area == 0) continue;
        const Point place{mix(x), mix(y)};
        const LatticePlace found = old_.find(place, guess);
        const double water = area * old_depth(place, found);
        through.level += water + area * bottom(place);
        through.momentum.x += water * old_.value(old_values(0), found);
        through.momentum.y += water * old_.value(old_values(1), found);
        through.water += water;
      }
    }
    // The momentum of the same water that the volumes count.
    const double exact = through.level - under;
    if (through.water != 0 && std::abs(exact - through.water) < 0.5 * std::abs(through.water)) {
      through.momentum.x *= exact / through.water;
      through.momentum.y *= exact / through.water;
    }
    through.water = exact;
    return through;
  }

  void sweep() {
    gained_.assign(shape_.cells(), {});
    const auto add = [&](std::size_t cell, double sign, const Content& through) {
      gained_[cell].level += sign * through.level;
      gained_[cell].water += sign * through.water;
      gained_[cell].momentum.x += sign * through.momentum.x;
      gained_[cell].momentum.y += sign * through.momentum.y;
    };
    const auto columns = shape_.columns;
    for (std::size_t j = 0; j <= shape_.rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        const bool closed = j == 0 || j == shape_.rows;
        const LatticePlace guess{.i = static_cast<double>(i) + 0.5, .j = static_cast<double>(j)};
        const Content through = swept(shape_.node(i, j), shape_.node(i + 1, j), guess, closed);
        if (j < shape_.rows) add(j * columns + i, 1, through);
        if (j > 0) add((j - 1) * columns + i, -1, through);
      }
    }
    for (std::size_t j = 0; j < shape_.rows; ++j) {
      for (std::size_t i = 0; i <= columns; ++i) {
        const bool closed = i == 0 || i == columns;
        const LatticePlace guess{.i = static_cast<double>(i), .j = static_cast<double>(j) + 0.5};
        const Content through = swept(shape_.node(i, j), shape_.node(i, j + 1), guess, closed);
        if (i > 0) add(j * columns + i - 1, 1, through);
        if (i < columns) add(j * columns + i, -1, through);
      }
    }
  }

  [[nodiscard]] std::array<Point, 4> corners_of(std::size_t cell, bool fresh) const {
    const auto corners = shape_.corners(cell);
    const auto at = [&](std::size_t a) { return fresh ? new_point(corners[a]) : old_point(corners[a]); };
    return {at(0), at(1), at(2), at(3)};
  }

  [[nodiscard]] double new_level(std::size_t cell) const {
    const auto corners = shape_.corners(cell);
    const auto at = [&](const std::vector<double>& values) {
      return Corners{values[corners[0]], values[corners[1]], values[corners[2]], values[corners[3]]};
    };
    return bilinear_patch::volume(at(now_.lattice.x), at(now_.lattice.y), at(now_.lattice.z));
  }

  /// V* and what the surface has too little of it, to the nodes.
  void level_water() {
    volume_.resize(shape_.cells());
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      under_.push_back(bottom_under(corners_of(cell, true)));
      volume_[cell] =
          model_.first_volumes()[cell] + gained_[cell].level - under_[cell] + bottom_under(corners_of(cell, false));
      if (!(volume_[cell] > 0)) {
        throw mechanics::Infeasible(fmt::format("cell {} would hold {:g} of water", cell, volume_[cell]),
                                    corners_of(cell, true)[0].x);
      }
    }
    // dV/dz of the nodes, and how many corners of a cell are not on a shoreline.
    std::vector<double> area(n_, 0.0);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto corners = shape_.corners(cell);
      const auto at = corners_of(cell, true);
      const auto threes = bilinear_patch::threes(
          bilinear_patch::jacobians({at[0].x, at[1].x, at[2].x, at[3].x}, {at[0].y, at[1].y, at[2].y, at[3].y}));
      const std::array by_z{threes.c0 / 12, threes.c1 / 12, threes.c2 / 12, threes.c3 / 12};
      for (std::size_t a = 0; a < 4; ++a) area[corners[a]] += by_z[a];
    }
    for (int pass = 0; pass < passes; ++pass) {
      std::vector<double> rise(n_, 0.0);
      for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
        const auto corners = shape_.corners(cell);
        const double lacking = volume_[cell] - (new_level(cell) - under_[cell]);
        double wet = 0;
        for (const std::size_t k : corners) wet += on_shore_[k] != 0 ? 0.0 : 1.0;
        for (const std::size_t k : corners) {
          if (on_shore_[k] == 0) rise[k] += lacking / (wet * area[k]);
        }
      }
      for (std::size_t k = 0; k < n_; ++k) {
        now_.lattice.z[k] += rise[k];
        if (on_shore_[k] != 0 || now_.lattice.z[k] > bottom(new_point(k))) continue;
        throw mechanics::Infeasible(
            fmt::format("a column at ({:g}, {:g}) would have no water", now_.lattice.x[k], now_.lattice.y[k]),
            now_.lattice.x[k]);
      }
    }
  }

  /// The same for the momentum.
  void level_momentum() {
    const auto share = [&](std::size_t k) { return on_shore_[k] != 0 ? Shoreline::share_of_mass : 0.25; };
    std::vector<double> mass(n_, 0.0);
    std::vector<double> after(shape_.cells());
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      after[cell] = new_level(cell) - under_[cell];
      for (const std::size_t k : shape_.corners(cell)) mass[k] += share(k) * after[cell];
    }
    std::vector<Point> change(n_);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto corners = shape_.corners(cell);
      double shares = 0;
      Point before{};
      Point now{};
      for (const std::size_t k : corners) {
        shares += share(k);
        before.x += share(k) * u_[k];
        before.y += share(k) * u_[n_ + k];
        now.x += share(k) * now_.u[k];
        now.y += share(k) * now_.v[k];
      }
      const double was = model_.first_volumes()[cell] / shares;
      const double is = after[cell] / shares;
      const Point lacking{was * before.x + gained_[cell].momentum.x - is * now.x,
                          was * before.y + gained_[cell].momentum.y - is * now.y};
      for (const std::size_t k : corners) {
        change[k].x += share(k) * lacking.x / mass[k];
        change[k].y += share(k) * lacking.y / mass[k];
      }
    }
    for (std::size_t k = 0; k < n_; ++k) {
      now_.u[k] += change[k].x;
      now_.v[k] += change[k].y;
    }
  }

  static constexpr int passes = 2;

  const Model& model_;
  plan_lattice::Shape shape_;
  std::size_t n_;
  Input q_, u_;
  LatticeInterpolant old_;
  std::vector<char> on_shore_;
  std::vector<double> depth_;
  BottomVolume quadrilateral_;
  Remapped now_;
  std::vector<LatticePlace> places_;
  std::vector<Content> gained_;
  std::vector<double> under_;  // bottom_under of the new cells
  std::vector<double> volume_;
};

}  // namespace

Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y) {
  return Remap(model, q, u, std::move(x), std::move(y)).run();
}

}  // namespace seiche::dispersive_shallow_water_2d
