#include "seiche/models/dispersive_shallow_water_2d/rezone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/geometry/swept_quadrilateral.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/plan_lattice/lattice_interpolant.hpp"
#include "seiche/require.hpp"

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
    carry();
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
    for (std::size_t k = 0; k < n_; ++k) places_.push_back(old_.find(new_point(k), node_of(k)));
  }

  [[nodiscard]] LatticePlace node_of(std::size_t k) const {
    const std::size_t row = k / (shape_.columns + 1);
    return {.i = static_cast<double>(k - shape_.node(0, row)), .j = static_cast<double>(row)};
  }

  void interpolate() {
    now_.u.resize(n_);
    now_.v.resize(n_);
    now_.w.resize(n_);
    for (std::size_t k = 0; k < n_; ++k) {
      const Point at = new_point(k);
      bed_.push_back(bottom(at));
      now_.lattice.z[k] = bed_[k] + (on_shore_[k] != 0 ? 0.0 : old_depth(at, places_[k]));
      now_.u[k] = old_.value(old_values(0), places_[k]);
      now_.v[k] = old_.value(old_values(1), places_[k]);
      now_.w[k] = old_.value(old_values(2), places_[k]);
    }
  }

  /// What the edge p -> q sweeps towards its right.
  [[nodiscard]] Content swept(std::size_t p, std::size_t q, bool closed) const {
    const std::array at{old_point(p), new_point(p), new_point(q), old_point(q)};
    Content through;
    const double under = bottom_under(at);
    if (closed) {
      through.level = under;
      return through;
    }
    const std::array corner{node_of(p), places_[p], places_[q], node_of(q)};
    const std::array columns{corner[0].i, corner[1].i, corner[2].i, corner[3].i};
    const std::array rows{corner[0].j, corner[1].j, corner[2].j, corner[3].j};
    each_swept_point(at, [&](const SweptPoint& point) {
      const LatticePlace found = old_.find(point.place, {.i = point.mix(columns), .j = point.mix(rows)});
      const double water = point.area * old_depth(point.place, found);
      through.level += water + point.area * bottom(point.place);
      through.momentum.x += water * old_.value(old_values(0), found);
      through.momentum.y += water * old_.value(old_values(1), found);
      through.water += water;
    });
    // The momentum of the same water that the volumes count.
    const double exact = through.level - under;
    if (through.water != 0 && std::abs(exact - through.water) < 0.5 * std::abs(through.water)) {
      through.momentum.x *= exact / through.water;
      through.momentum.y *= exact / through.water;
    }
    through.water = exact;
    return through;
  }

  /// Through an edge, from one cell into another; none of them: a side.
  struct Passage {
    std::optional<std::size_t> into, from;
    Content content;
  };

  void sweep() {
    const auto columns = shape_.columns;
    for (std::size_t j = 0; j <= shape_.rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        const bool closed = j == 0 || j == shape_.rows;
        Passage one{.into = {}, .from = {}, .content = swept(shape_.node(i, j), shape_.node(i + 1, j), closed)};
        if (j < shape_.rows) one.into = j * columns + i;
        if (j > 0) one.from = (j - 1) * columns + i;
        passages_.push_back(one);
      }
    }
    for (std::size_t j = 0; j < shape_.rows; ++j) {
      for (std::size_t i = 0; i <= columns; ++i) {
        const bool closed = i == 0 || i == columns;
        Passage one{.into = {}, .from = {}, .content = swept(shape_.node(i, j), shape_.node(i, j + 1), closed)};
        if (i > 0) one.into = j * columns + i - 1;
        if (i < columns) one.from = j * columns + i;
        passages_.push_back(one);
      }
    }
  }

  /// V* and P*. No cell loses more than most of its water to others: what would be too much stays, all in proportion.
  void carry() {
    std::vector<double> leaves(shape_.cells(), 0.0);
    const auto loser = [](const Passage& one) { return one.content.water > 0 ? one.from : one.into; };
    for (const Passage& one : passages_) {
      if (const auto cell = loser(one)) leaves[*cell] += std::abs(one.content.water);
    }
    std::vector<double> level(shape_.cells(), 0.0);
    momentum_.resize(shape_.cells());
    for (const Passage& one : passages_) {
      double part = 1;
      if (const auto cell = loser(one)) part = std::min(1.0, most_lost * model_.first_volumes()[*cell] / leaves[*cell]);
      now_.displaced += (1 - part) * std::abs(one.content.water);
      const auto add = [&](std::size_t cell, double sign) {
        level[cell] += sign * (one.content.level - (1 - part) * one.content.water);
        momentum_[cell].x += sign * part * one.content.momentum.x;
        momentum_[cell].y += sign * part * one.content.momentum.y;
      };
      if (one.into) add(*one.into, 1);
      if (one.from) add(*one.from, -1);
    }
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      under_.push_back(bottom_under(corners_of(cell, true)));
      const double before = model_.first_volumes()[cell];
      volume_.push_back(before + level[cell] - under_[cell] + bottom_under(corners_of(cell, false)));
      if (!(volume_[cell] > 0)) {
        throw mechanics::Infeasible(fmt::format("cell {} would hold {:g} of water", cell, volume_[cell]),
                                    corners_of(cell, true)[0].x);
      }
      const Point velocity = mean_velocity(cell, u_.first(n_), u_.subspan(n_, n_));
      momentum_[cell].x += before * velocity.x;
      momentum_[cell].y += before * velocity.y;
    }
  }

  [[nodiscard]] double share(std::size_t k) const { return on_shore_[k] != 0 ? Shoreline::share_of_mass : 0.25; }

  [[nodiscard]] Point mean_velocity(std::size_t cell, std::span<const double> u, std::span<const double> v) const {
    double shares = 0;
    Point sum;
    for (const std::size_t k : shape_.corners(cell)) {
      shares += share(k);
      sum.x += share(k) * u[k];
      sum.y += share(k) * v[k];
    }
    return {sum.x / shares, sum.y / shares};
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

  /// Columns that the interpolation leaves nearly dry begin with a part of the mean depth of their cells.
  void fill_thin_columns() {
    std::vector<double> water(n_, 0.0);
    std::vector<double> area(n_, 0.0);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto at = corners_of(cell, true);
      const auto j =
          bilinear_patch::jacobians({at[0].x, at[1].x, at[2].x, at[3].x}, {at[0].y, at[1].y, at[2].y, at[3].y});
      for (const std::size_t k : shape_.corners(cell)) {
        water[k] += volume_[cell];
        area[k] += 0.5 * (j.c0 + j.c2);
      }
    }
    for (std::size_t k = 0; k < n_; ++k) {
      if (on_shore_[k] != 0) continue;
      now_.lattice.z[k] = std::max(now_.lattice.z[k], bed_[k] + thinnest * water[k] / area[k]);
    }
  }

  /// What the surface has too little of V*, to the nodes.
  void level_water() {
    fill_thin_columns();
    // dV/dz of the nodes.
    std::vector<double> area(n_, 0.0);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto corners = shape_.corners(cell);
      const auto at = corners_of(cell, true);
      const auto threes = bilinear_patch::threes(
          bilinear_patch::jacobians({at[0].x, at[1].x, at[2].x, at[3].x}, {at[0].y, at[1].y, at[2].y, at[3].y}));
      const std::array by_z{threes.c0 / 12, threes.c1 / 12, threes.c2 / 12, threes.c3 / 12};
      for (std::size_t a = 0; a < 4; ++a) area[corners[a]] += by_z[a];
    }
    std::vector<char> sank;
    for (int pass = 0; pass < passes || std::ranges::count(sank, 1) > 0; ++pass) {
      if (pass == most_passes) {
        throw mechanics::Infeasible(
            "columns would have no water",
            now_.lattice.x[static_cast<std::size_t>(std::ranges::find(sank, 1) - sank.begin())]);
      }
      if (pass >= passes) share_with_neighbours(sank);
      sank = raise(area);
    }
  }

  /// One pass. A column sinks by a part of its depth at most: marks those that should sink more.
  std::vector<char> raise(const std::vector<double>& area) {
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
    std::vector<char> sank(n_, 0);
    for (std::size_t k = 0; k < n_; ++k) {
      if (on_shore_[k] != 0) continue;
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
    const Point momentum{part * momentum_[from].x, part * momentum_[from].y};
    volume_[from] -= water;
    volume_[into] += water;
    momentum_[from].x -= momentum.x;
    momentum_[from].y -= momentum.y;
    momentum_[into].x += momentum.x;
    momentum_[into].y += momentum.y;
    now_.displaced += water;
  }

  /// The same for the momentum.
  void level_momentum() {
    std::vector<double> mass(n_, 0.0);
    std::vector<double> after(shape_.cells());
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      after[cell] = new_level(cell) - under_[cell];
      for (const std::size_t k : shape_.corners(cell)) mass[k] += share(k) * after[cell];
    }
    std::vector<Point> change(n_);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const Point velocity = mean_velocity(cell, now_.u, now_.v);
      const Point lacking{momentum_[cell].x - after[cell] * velocity.x, momentum_[cell].y - after[cell] * velocity.y};
      for (const std::size_t k : shape_.corners(cell)) {
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
  static constexpr int most_passes = 100;
  static constexpr double most_lost = 0.75;  // of a cell's water, in a remap
  static constexpr double most_sunk = 0.3;   // of a column's depth, in a pass
  static constexpr double thinnest = 0.25;   // column, over the mean depth of its cells

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
  std::vector<double> bed_;  // below the new nodes
  std::vector<Passage> passages_;
  std::vector<double> under_;   // bottom_under of the new cells
  std::vector<double> volume_;  // V*
  std::vector<Point> momentum_;
};

}  // namespace

Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y) {
  return Remap(model, q, u, std::move(x), std::move(y)).run();
}

namespace {

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// What a sequence has of the pattern + - + -, by its fourth difference; it goes on symmetrically beyond its ends.
std::vector<double> pattern(const std::vector<double>& values) {
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  const auto at = [&](std::ptrdiff_t k) {
    return values[static_cast<std::size_t>(k < 0 ? -k : k > last ? 2 * last - k : k)];
  };
  std::vector<double> part;
  for (std::ptrdiff_t k = 0; k <= last; ++k) {
    part.push_back((at(k - 2) - 4 * at(k - 1) + 6 * at(k) - 4 * at(k + 1) + at(k + 2)) / 16);
  }
  return part;
}

constexpr int most_parts = 8;     // of a step, by its strain
constexpr int most_halvings = 5;  // of one that fails

}  // namespace

ShoreFollowing::ShoreFollowing(const Lattice& first, RezoneSettings settings)
    : shape_(first.shape), settings_(settings) {
  require_within("drift", settings.drift, 1e-6, 2);
  require_within("narrowest", settings.narrowest, 0, 0.99);
  require_not_negative("edge_slope", settings.edge_slope);
  require_not_negative("shore_slope", settings.shore_slope);
  require_within("strain", settings.strain, 1e-6, 1);
  if (!std::holds_alternative<plan_lattice::ShoreSide>(first.sides.south)) {
    throw std::invalid_argument("a lattice without a shoreline on its south side; allowed: one with it");
  }
  require_at_least("columns", static_cast<long>(shape_.columns), 3);
  for (std::size_t k = 0; k < shape_.nodes(); ++k) first_.push_back({first.x[k], first.y[k]});
  for (std::size_t i = 0; i <= shape_.columns; ++i) {
    const double length = distance(first_[i], outer(i));
    line_.push_back({(outer(i).x - first_[i].x) / length, (outer(i).y - first_[i].y) / length});
  }
}

ShoreFollowing::Places ShoreFollowing::places(Input q, Input volumes) const {
  const std::size_t n = shape_.nodes();
  const std::size_t count = shape_.columns + 1;
  Places places;
  for (std::size_t j = 0; j < shape_.rows; ++j) {
    const plan_lattice::RowCurve row(q.subspan(j * count, count), q.subspan(n + j * count, count));
    std::vector<double> away;
    for (std::size_t i = 0; i < count; ++i) {
      const bool end = i == 0 || i == shape_.columns;
      const Point place = end ? row.at(static_cast<double>(i)) : row.meet(i, first_[i], outer(i));
      places.x.push_back(place.x);
      places.y.push_back(place.y);
      const Point from = first_[shape_.node(i, j)];
      away.push_back((place.x - from.x) * line_[i].x + (place.y - from.y) * line_[i].y);
    }
    const std::vector<double> rough = pattern(away);
    for (std::size_t i = 0; i < count; ++i) {
      places.x[shape_.node(i, j)] -= rough[i] * line_[i].x;
      places.y[shape_.node(i, j)] -= rough[i] * line_[i].y;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    places.x.push_back(outer(i).x);
    places.y.push_back(outer(i).y);
  }
  if (settings_.edge_slope > 0) draw_back_films(q, volumes, places);
  if (settings_.shore_slope > 0) cut_tongues(places);
  keep_widths(places);
  return places;
}

/// The cells beside a column, from the shoreline to a row, are a wedge of depth h over its width b; with its water it
/// has the depth over its width asked for when it is sqrt(h/(b edge_slope)) as wide. The film is the widest wedge that
/// is too thin, as long as all within it are.
void ShoreFollowing::draw_back_films(Input q, Input volumes, Places& places) const {
  const std::size_t count = shape_.columns + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Point shore{places.x[i], places.y[i]};
    double water = 0;
    double area = 0;
    double part = 1;
    std::size_t film = 0;
    for (std::size_t row = 0; row + 1 < shape_.rows; ++row) {
      const std::size_t first = row * shape_.columns;
      for (const std::size_t cell : {first + (i > 0 ? i - 1 : 0), first + std::min(i, shape_.columns - 1)}) {
        water += volumes[cell];
        area += cell_area(shape_, q, cell);
      }
      const std::size_t base = shape_.node(i, row + 1);
      const double slope = 2 * water / area / distance(shore, {places.x[base], places.y[base]});
      if (!(slope < settings_.edge_slope)) break;
      part = std::sqrt(slope / settings_.edge_slope);
      film = row + 1;
    }
    const std::size_t base = shape_.node(i, film);
    for (std::size_t k = i; k < base; k += count) {
      places.x[k] = std::lerp(places.x[base], places.x[k], part);
      places.y[k] = std::lerp(places.y[base], places.y[k], part);
    }
  }
}

void ShoreFollowing::cut_tongues(Places& places) const {
  constexpr double least_left = 0.7;  // of a pressed cell's width
  const std::size_t count = shape_.columns + 1;
  const auto outwards = [&](std::size_t i, std::size_t j) {
    const std::size_t k = shape_.node(i, j);
    return (places.x[k] - first_[i].x) * line_[i].x + (places.y[k] - first_[i].y) * line_[i].y;
  };
  std::vector<double> shore(count);
  for (std::size_t i = 0; i < count; ++i) shore[i] = outwards(i, 0);
  const auto limit = [&](std::size_t i, std::size_t beside) {
    shore[i] = std::max(shore[i], shore[beside] - settings_.shore_slope * distance(first_[i], first_[beside]));
  };
  for (std::size_t i = 1; i < count; ++i) limit(i, i - 1);
  for (std::size_t i = count - 1; i-- > 0;) limit(i, i + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double was = outwards(i, 0);
    if (!(shore[i] > was)) continue;
    std::size_t row = 1;
    while (row + 1 < shape_.rows && outwards(i, row) - shore[i] < least_left * (outwards(i, row) - was)) ++row;
    const double base = outwards(i, row);
    const double part = (base - shore[i]) / (base - was);
    const std::size_t out = shape_.node(i, row);
    for (std::size_t k = i; k < out; k += count) {
      places.x[k] = std::lerp(places.x[out], places.x[k], part);
      places.y[k] = std::lerp(places.y[out], places.y[k], part);
    }
  }
}

void ShoreFollowing::keep_widths(Places& places) const {
  for (std::size_t j = 1; j < shape_.rows; ++j) {
    for (std::size_t i = 0; i <= shape_.columns; ++i) {
      const std::size_t k = shape_.node(i, j);
      const std::size_t inner = shape_.node(i, j - 1);
      const Point line = line_[i];
      const double width = (places.x[k] - places.x[inner]) * line.x + (places.y[k] - places.y[inner]) * line.y;
      const double lacking = settings_.narrowest * distance(first_[inner], first_[k]) - width;
      if (!(lacking > 0)) continue;
      places.x[k] += lacking * line.x;
      places.y[k] += lacking * line.y;
    }
  }
}

double ShoreFollowing::drift(Input q, const Places& places) const {
  const std::size_t n = shape_.nodes();
  return plan_lattice::farthest(shape_, q.first(n), q.subspan(n, n), places);
}

RezonedFlow::RezonedFlow(Lattice lattice, const InitialVelocity& velocity, Scheme scheme, Settings settings,
                         RezoneSettings rezone)
    : following_(lattice, rezone),
      scheme_(scheme),
      settings_(rezone),
      flow_(std::make_unique<Flow>(std::move(lattice), velocity, scheme, std::move(settings), Forcing{}, Window{},
                                   false)) {
  if (flow_->model().has_driven_sides()) throw std::invalid_argument("a rezoned lattice with driven sides");
}

std::vector<Invariant> RezonedFlow::invariants() const {
  std::vector<Invariant> all = flow_->invariants();
  const auto energy = std::find_if(all.begin(), all.end(), [](const Invariant& i) { return i.name == "energy"; });
  energy->value += base_;
  energy->booked -= lost_;
  return all;
}

void RezonedFlow::advance(double tau) {
  mechanics::require_step(tau);
  const double strained = std::ceil(rate_of_strain() * tau / settings_.strain);
  double step = tau / std::clamp(strained, 1.0, static_cast<double>(most_parts));
  double left = tau;
  bool failed = false;
  for (int halvings = 0; left > 1e-9 * tau;) {
    follow(failed);
    try {
      flow_->advance(std::min(step, left));
      left -= step;
      failed = false;
    } catch (const Divergence& failure) {
      if (halvings == most_halvings) throw Divergence(failure.what(), time(), steps(), failure.place());
      failed = true;
      halved_ += halvings == 0 ? 1 : 0;
      ++halvings;
      step /= 2;
    }
  }
}

/// Of the edges of all cells, by the velocities of their ends.
double RezonedFlow::rate_of_strain() const {
  const Input q = flow_->state().q;
  const Input u = flow_->state().u;
  const Shape shape = flow_->shape();
  const std::size_t n = shape.nodes();
  double fastest = 0;
  const auto look = [&](std::size_t from, std::size_t to) {
    const double change = std::hypot(u[to] - u[from], u[n + to] - u[n + from]);
    fastest = std::max(fastest, change / distance({q[from], q[n + from]}, {q[to], q[n + to]}));
  };
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    for (std::size_t i = 0; i <= shape.columns; ++i) {
      if (i < shape.columns) look(shape.node(i, j), shape.node(i + 1, j));
      if (j < shape.rows) look(shape.node(i, j), shape.node(i, j + 1));
    }
  }
  return fastest;
}

/// Rezones where nodes have drifted too far, or anyway.
void RezonedFlow::follow(bool anyway) {
  const ShoreFollowing::Places places = following_.places(flow_->state().q, flow_->model().first_volumes());
  if (!anyway && !(following_.drift(flow_->state().q, places) > settings_.drift)) return;
  try {
    rezone(places);
  } catch (const mechanics::Infeasible&) {
    ++refused_;
  } catch (const Divergence&) {  // a new flow that cannot begin
    ++refused_;
  } catch (const std::invalid_argument&) {  // a surface that leaves a cell without water
    ++refused_;
  }
}

void RezonedFlow::rezone(const ShoreFollowing::Places& places) {
  const Model& model = flow_->model();
  const mechanics::State& state = flow_->state();
  Remapped now = remap(model, state.q, state.u, places.x, places.y);
  std::vector<Velocity> velocity;
  for (std::size_t k = 0; k < model.nodes(); ++k) velocity.push_back({now.u[k], now.v[k], now.w[k]});
  auto flow = std::make_unique<Flow>(std::move(now.lattice), std::move(velocity), scheme_, model.settings(), Forcing{},
                                     Window{}, false);
  flow->continue_breaking(*flow_);
  // Of both lattices the potential counts from the first one's shoreline: its ways do not meet the bottom's moment.
  const mechanics::State& next = flow->state();
  const double before = flow_->energy();
  const double potential = model.potential_energy(next.q);
  const double after = flow->model().kinetic_energy(next.q, next.u) + potential;
  base_ += potential - flow->model().potential_energy(next.q);
  lost_ += before - after;
  displaced_ += now.displaced;
  begin_ += flow_->time();
  steps_ += flow_->steps();
  ++rezoned_;
  flow_ = std::move(flow);
}

}  // namespace seiche::dispersive_shallow_water_2d
