#include "validation/instruments/plan/plan_remap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/plan_lattice/swept_remap.hpp"

namespace seiche::validation {

using dispersive_shallow_water_2d::Lattice, dispersive_shallow_water_2d::Model;
using mechanics::Input;
using plan_lattice::Shape;

namespace {

using plan_lattice::LatticePlace;
using plan_lattice::SweptRemap;

using bilinear_patch::Corners;
using Quadrilateral = std::array<Point, 4>;

Corners jacobians(const Quadrilateral& at) {
  return bilinear_patch::jacobians({at[0].x, at[1].x, at[2].x, at[3].x}, {at[0].y, at[1].y, at[2].y, at[3].y});
}

/// Throws mechanics::Infeasible for a cell that is not convex.
Lattice moved(Lattice lattice, std::vector<double> x, std::vector<double> y) {
  plan_lattice::require_convex(lattice.shape, x, y);
  lattice.x = std::move(x);
  lattice.y = std::move(y);
  return lattice;
}

std::vector<double> shares_of(const Lattice& lattice) {
  std::vector<double> shares(lattice.shape.nodes(), 0.25);
  for (const auto& edge : plan_lattice::shore_edges(lattice.shape, lattice.sides)) {
    for (const std::size_t k : edge) shares[k] = dispersive_shallow_water_2d::Shoreline::share_of_mass;
  }
  return shares;
}

class Remap {
 public:
  Remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y)
      : model_(model),
        shape_(model.shape()),
        n_(shape_.nodes()),
        q_(q),
        u_(u),
        now_{.lattice = moved(model.lattice(), std::move(x), std::move(y)), .velocity = {}},
        swept_(shape_, q.first(n_), q.subspan(n_, n_), now_.lattice.x, now_.lattice.y, shares_of(now_.lattice)),
        bottom_(shape_, model.lattice().bottom) {
    for (std::size_t k = 0; k < n_; ++k) {
      depth_.push_back(on_shore(k) ? 0 : q_[2 * n_ + k] - bottom(swept_.old_point(k)));
    }
  }

  Remapped run() {
    interpolate();
    carry();
    level_water();
    level_momentum();
    return std::move(now_);
  }

 private:
  [[nodiscard]] bool on_shore(std::size_t k) const { return swept_.share(k) != 0.25; }
  [[nodiscard]] double old_value(std::size_t axis, const LatticePlace& at) const {
    return swept_.old().value(u_.subspan(axis * n_, n_), at);
  }
  [[nodiscard]] double bottom(Point at) const { return now_.lattice.bed(at.x, at.y); }

  /// Depth of the old surface: the cubic one's, as long as the bilinear one is near it. In a thin sheet the cubic one
  /// would go below the bottom.
  [[nodiscard]] double old_depth(Point at, const LatticePlace& found) const {
    const double linear = swept_.old().linear_value(depth_, found);
    return std::clamp(swept_.old().value(q_.subspan(2 * n_, n_), found) - bottom(at), linear / 2, 2 * linear);
  }

  /// int b dA of the quadrilateral, by the rule of the model's volumes.
  [[nodiscard]] double bottom_under(const Quadrilateral& at) const {
    if (now_.lattice.bottom) return bottom_.volume(at);
    const Corners j = jacobians(at);
    return -now_.lattice.depth * 0.5 * (j.c0 + j.c2);
  }

  void interpolate() {
    for (std::size_t k = 0; k < n_; ++k) {
      const LatticePlace& at = swept_.place(k);
      bed_.push_back(bottom(swept_.new_point(k)));
      now_.lattice.z[k] = bed_[k] + (on_shore(k) ? 0.0 : old_depth(swept_.new_point(k), at));
      now_.velocity.push_back({old_value(0, at), old_value(1, at), old_value(2, at)});
    }
  }

  /// Through an edge, from one cell into another; Shape::outside: a side.
  struct Passage {
    std::size_t into, from;
    double level = 0;  ///< int z dA
    double water = 0;  ///< int H dA
    Point momentum{};  ///< int H u dA

    /// The cell that it takes water from.
    [[nodiscard]] std::size_t loser() const { return water > 0 ? from : into; }
  };

  /// What the edge p -> q sweeps towards its right.
  [[nodiscard]] Passage passage(std::size_t p, std::size_t q, std::size_t into, std::size_t from) const {
    Passage through{.into = into, .from = from};
    const double under = bottom_under(swept_.swept(p, q));
    if (into == Shape::outside || from == Shape::outside) {
      through.level = under;
      return through;
    }
    swept_.each_swept(p, q, [&](const SweptPoint& point, const LatticePlace& found) {
      const double water = point.area * old_depth(point.place, found);
      through.level += water + point.area * bottom(point.place);
      through.momentum += water * Point{old_value(0, found), old_value(1, found)};
      through.water += water;
    });
    // The momentum of the same water that the volumes count.
    const double exact = through.level - under;
    if (through.water != 0 && std::abs(exact - through.water) < 0.5 * std::abs(through.water)) {
      through.momentum = exact / through.water * through.momentum;
    }
    through.water = exact;
    return through;
  }

  /// V* and P*. No cell loses more than most of its water to others: what would be too much stays, all in proportion.
  void carry() {
    std::vector<Passage> passages;
    std::vector<double> leaves(shape_.cells(), 0.0);
    shape_.each_edge([&](std::size_t p, std::size_t q, std::size_t into, std::size_t from) {
      passages.push_back(passage(p, q, into, from));
      const std::size_t loser = passages.back().loser();
      if (loser != Shape::outside) leaves[loser] += std::abs(passages.back().water);
    });
    std::vector<double> level(shape_.cells(), 0.0);
    momentum_.resize(shape_.cells());
    for (const Passage& one : passages) {
      const std::size_t loser = one.loser();
      const double part =
          loser == Shape::outside ? 1 : std::min(1.0, most_lost * model_.first_volumes()[loser] / leaves[loser]);
      now_.displaced += (1 - part) * std::abs(one.water);
      const auto add = [&](std::size_t cell, double sign) {
        if (cell == Shape::outside) return;
        level[cell] += sign * (one.level - (1 - part) * one.water);
        momentum_[cell] += sign * part * one.momentum;
      };
      add(one.into, 1);
      add(one.from, -1);
    }
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      under_.push_back(bottom_under(corners_of(cell, true)));
      const double before = model_.first_volumes()[cell];
      volume_.push_back(before + level[cell] - under_[cell] + bottom_under(corners_of(cell, false)));
      if (!(volume_[cell] > 0)) {
        throw mechanics::Infeasible(corners_of(cell, true)[0].x, "cell {} would hold {:g} of water", cell,
                                    volume_[cell]);
      }
      momentum_[cell] += before * swept_.mean(cell, [&](std::size_t k) { return Point{u_[k], u_[n_ + k]}; });
    }
  }

  [[nodiscard]] Quadrilateral corners_of(std::size_t cell, bool fresh) const {
    const auto corners = shape_.corners(cell);
    const auto at = [&](std::size_t a) { return fresh ? swept_.new_point(corners[a]) : swept_.old_point(corners[a]); };
    return {at(0), at(1), at(2), at(3)};
  }

  [[nodiscard]] double new_level(std::size_t cell) const {
    const auto corners = shape_.corners(cell);
    const auto at = [&](std::span<const double> values) { return bilinear_patch::at_corners(values, corners); };
    return bilinear_patch::volume(at(now_.lattice.x), at(now_.lattice.y), at(now_.lattice.z));
  }

  /// What the surface has too little of V*, to the nodes. Columns that the interpolation leaves nearly dry begin with a
  /// part of the mean depth of their cells.
  void level_water() {
    // Around the nodes; by_z is dV/dz.
    std::vector<double> water(n_, 0.0), area(n_, 0.0), by_z(n_, 0.0);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto corners = shape_.corners(cell);
      const Corners j = jacobians(corners_of(cell, true));
      const Corners threes = bilinear_patch::threes(j);
      const std::array rises{threes.c0 / 12, threes.c1 / 12, threes.c2 / 12, threes.c3 / 12};
      for (std::size_t a = 0; a < 4; ++a) {
        water[corners[a]] += volume_[cell];
        area[corners[a]] += 0.5 * (j.c0 + j.c2);
        by_z[corners[a]] += rises[a];
      }
    }
    for (std::size_t k = 0; k < n_; ++k) {
      if (on_shore(k)) continue;
      const double lowest = bed_[k] + thinnest * water[k] / area[k];
      if (now_.lattice.z[k] < lowest) now_.lattice.z[k] = lowest;
    }
    std::vector<char> sank;
    for (int pass = 0; pass < passes || std::ranges::count(sank, 1) > 0; ++pass) {
      if (pass == most_passes) {
        throw mechanics::Infeasible(
            "columns would have no water",
            now_.lattice.x[static_cast<std::size_t>(std::ranges::find(sank, 1) - sank.begin())]);
      }
      if (pass >= passes) share_with_neighbours(sank);
      sank = raise(by_z);
    }
  }

  /// One pass. A column sinks by a part of its depth at most: marks those that should sink more.
  std::vector<char> raise(const std::vector<double>& by_z) {
    std::vector<double> rise(n_, 0.0);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto corners = shape_.corners(cell);
      const double lacking = volume_[cell] - (new_level(cell) - under_[cell]);
      double wet = 0;
      for (const std::size_t k : corners) wet += on_shore(k) ? 0.0 : 1.0;
      for (const std::size_t k : corners) {
        if (!on_shore(k)) rise[k] += lacking / (wet * by_z[k]);
      }
    }
    std::vector<char> sank(n_, 0);
    for (std::size_t k = 0; k < n_; ++k) {
      if (on_shore(k)) continue;
      const double least = -most_sunk * (now_.lattice.z[k] - bed_[k]);
      sank[k] = rise[k] < least ? 1 : 0;
      now_.lattice.z[k] += std::max(rise[k], least);
    }
    return sank;
  }

  /// Columns cannot leave a cell with so little water while the ones beside it hold theirs: it gets of these.
  void share_with_neighbours(const std::vector<char>& sank) {
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      if (std::ranges::none_of(shape_.corners(cell), [&](std::size_t k) { return sank[k] != 0; })) continue;
      const double surplus = new_level(cell) - under_[cell] - volume_[cell];
      if (!(surplus > 0)) continue;
      const std::size_t columns = shape_.columns;
      if (cell % columns > 0) move_water(cell - 1, cell, surplus / 4);
      if (cell % columns + 1 < columns) move_water(cell + 1, cell, surplus / 4);
      if (cell >= columns) move_water(cell - columns, cell, surplus / 4);
      if (cell + columns < shape_.cells()) move_water(cell + columns, cell, surplus / 4);
    }
  }

  void move_water(std::size_t from, std::size_t into, double wanted) {
    const double part = std::min(wanted / volume_[from], 0.25);
    const double water = part * volume_[from];
    const Point momentum = part * momentum_[from];
    volume_[from] -= water;
    volume_[into] += water;
    momentum_[from] = momentum_[from] - momentum;
    momentum_[into] += momentum;
    now_.displaced += water;
  }

  /// The same for the momentum.
  void level_momentum() {
    std::vector<double> after;
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) after.push_back(new_level(cell) - under_[cell]);
    const auto change = swept_.lacking(after, momentum_, [&](std::size_t k) {
      return Point{now_.velocity[k].u, now_.velocity[k].v};
    });
    for (std::size_t k = 0; k < n_; ++k) {
      now_.velocity[k].u += change[k].x;
      now_.velocity[k].v += change[k].y;
    }
  }

  static constexpr int passes = 2;
  static constexpr int most_passes = 100;
  static constexpr double most_lost = 0.75;  // of a cell's water, in a remap
  static constexpr double most_sunk = 0.3;   // of a column's depth, in a pass
  static constexpr double thinnest = 0.25;   // column, over the mean depth of its cells

  const Model& model_;
  Shape shape_;
  std::size_t n_;
  Input q_, u_;
  Remapped now_;
  SweptRemap swept_;
  dispersive_shallow_water_2d::BottomVolume bottom_;
  std::vector<double> depth_;   // of the old nodes
  std::vector<double> bed_;     // below the new nodes
  std::vector<double> under_;   // bottom_under of the new cells
  std::vector<double> volume_;  // V*
  std::vector<Point> momentum_;
};

}  // namespace

Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y) {
  return Remap(model, q, u, std::move(x), std::move(y)).run();
}

}  // namespace seiche::validation
