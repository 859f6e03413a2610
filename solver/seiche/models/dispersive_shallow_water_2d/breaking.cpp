#include "seiche/models/dispersive_shallow_water_2d/breaking.hpp"

#include <algorithm>
#include <cmath>

#include "seiche/models/dispersive_shallow_water_2d/push.hpp"
#include "seiche/plan_lattice/window.hpp"
#include "seiche/shallow_water/breaking_bore.hpp"

namespace seiche::dispersive_shallow_water_2d {

BreakingFronts::BreakingFronts(double slope, double inertia, plan_lattice::Shape shape)
    : slope_(slope),
      inertia_(inertia),
      shape_(shape),
      broke_(slope > 0 ? (shape.rows + 1) * shape.columns + shape.rows * (shape.columns + 1) : 0, 0),
      breaks_(broke_) {}

void BreakingFronts::measure(std::span<const double> volumes, mechanics::Input q) {
  pairs_.clear();
  lines_.clear();
  found_ = false;
  for (std::size_t j = 0; j <= shape_.rows; ++j) look(volumes, q, j, true);
  for (std::size_t i = 0; i <= shape_.columns; ++i) look(volumes, q, i, false);
}

/// At one line, a row or what lies across the rows: keeps it if it is steep somewhere or broke.
void BreakingFronts::look(std::span<const double> volumes, mechanics::Input q, std::size_t line, bool is_row) {
  const std::size_t n = shape_.nodes();
  const std::size_t count = is_row ? shape_.columns : shape_.rows;
  const auto pair_at = [&](std::size_t k) {
    const std::size_t from = is_row ? shape_.node(k, line) : shape_.node(line, k);
    const std::size_t to = is_row ? from + 1 : from + shape_.columns + 1;
    const Point way{q[to] - q[from], q[n + to] - q[n + from]};
    const double rise = q[2 * n + to] - q[2 * n + from];
    const bool steep = rise * rise > slope_ * slope_ * (way.x * way.x + way.y * way.y);
    const std::size_t place = is_row ? line * shape_.columns + k : (shape_.rows + 1) * shape_.columns + from;
    return Pair{.from = from, .to = to, .place = place, .way = way, .rise = rise, .steep = steep};
  };
  bool kept = false;
  for (std::size_t k = 0; k < count && !kept; ++k) {
    const Pair pair = pair_at(k);
    kept = pair.steep || broke_[pair.place] != 0;
  }
  if (!kept) return;
  const std::size_t last = is_row ? shape_.rows : shape_.columns;
  const std::array beside{line > 0 ? line - 1 : 0, std::min(line, last - 1)};
  // On a side there is half of the water; its one cell is counted twice.
  const double share = beside[0] == beside[1] ? 1 : 2;
  for (std::size_t k = 0; k < count; ++k) {
    Pair pair = pair_at(k);
    double water = 0;
    double area = 0;
    for (const std::size_t strip : beside) {
      const std::size_t cell = is_row ? strip * shape_.columns + k : k * shape_.columns + strip;
      water += volumes[cell] / 4;
      area += cell_area(shape_, q, cell) / 4;
    }
    pair.depth = water / area;
    const double viscosity = 2 * std::sqrt(inertia_ * pair.depth) * pair.depth;
    pair.exchange = share * water * viscosity / (pair.way.x * pair.way.x + pair.way.y * pair.way.y);
    pairs_.push_back(pair);
  }
  lines_.push_back(pairs_.size());
}

void BreakingFronts::find(double gravity, mechanics::Input u) const {
  constexpr double least = 0.0015;
  const std::size_t n = shape_.nodes();
  const auto comes_nearer = [&](const Pair& pair) {
    const double nearer = (u[pair.from] - u[pair.to]) * pair.way.x + (u[n + pair.from] - u[n + pair.to]) * pair.way.y;
    const double square = pair.way.x * pair.way.x + pair.way.y * pair.way.y;
    return nearer > least * square * std::sqrt(gravity / pair.depth);
  };
  std::fill(breaks_.begin(), breaks_.end(), char{0});
  fronts_.clear();
  going_on_ = 0;
  std::size_t first = 0;
  for (const std::size_t end : lines_) {
    while (first < end) {
      std::size_t behind = first;
      bool steep = false;
      bool goes_on = false;
      for (; behind < end && comes_nearer(pairs_[behind]); ++behind) {
        steep = steep || pairs_[behind].steep;
        goes_on = goes_on || broke_[pairs_[behind].place] != 0;
      }
      const Front front{.first = first,
                        .pairs = behind - first,
                        .damping = steep || goes_on ? damping(std::span(pairs_).subspan(first, behind - first)) : 0.0};
      if (front.damping > 0) {
        fronts_.push_back(front);
        going_on_ += steep ? 0 : 1;
        for (std::size_t k = first; k < behind; ++k) breaks_[pairs_[k].place] = 1;
      }
      first = behind + 1;
    }
    first = end;
  }
  found_ = true;
}

/// Share of the viscosity by the height of a front over the depth at its lower end; 0 for what is no bore.
double BreakingFronts::damping(std::span<const Pair> pairs) {
  double level = 0;
  double highest = 0;
  for (const Pair& pair : pairs) {
    level += pair.rise;
    highest = std::max(highest, level);
  }
  const Pair& lowest = level > 0 ? pairs.front() : pairs.back();
  const double ahead = lowest.depth - 0.5 * std::abs(lowest.rise);
  const double rise = highest - std::min(0.0, level);
  if (shallow_water::bore_froude(ahead, rise) < shallow_water::weakest_breaking_bore) return 0;
  return shallow_water::bore_damping(ahead, rise);
}

void BreakingFronts::exchange(std::span<const double> masses, const InverseMasses& inverse, double gravity, double h,
                              mechanics::Output u) const {
  if (!found_) find(gravity, u);
  if (fronts_.empty()) return;
  before_.assign(u.begin(), u.end());
  for (const Front& front : fronts_) mix(front, h * std::sqrt(gravity) * front.damping, masses, inverse, before_, u);
}

void BreakingFronts::continue_from(const BreakingFronts& before) {
  broke_ = before.broke_;
}

void BreakingFronts::shift_east() {
  if (broke_.empty()) return;
  const std::span all(broke_);
  const auto shift = [](std::span<char> places, std::size_t length) {
    plan_lattice::shift_rows(places, length);
    for (std::size_t k = length - 1; k < places.size(); k += length) places[k] = 0;
  };
  const std::size_t along = (shape_.rows + 1) * shape_.columns;
  shift(all.first(along), shape_.columns);
  shift(all.subspan(along), shape_.columns + 1);
}

/// The mean of a step's velocities gets half of what those at its end get, (M + 2 h L) u' = M u, L the pairs: a front
/// along a row and one across take no more than all between them, and neither has to come first.
void BreakingFronts::mix(const Front& front, double time, std::span<const double> masses, const InverseMasses& inverse,
                         mechanics::Input before, mechanics::Output u) const {
  const std::size_t n = masses.size();
  const auto pairs = std::span(pairs_).subspan(front.first, front.pairs);
  const std::size_t count = pairs.size() + 1;
  diagonal_.resize(count);
  coupling_.resize(count);
  for (std::vector<double>& speeds : speed_) speeds.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t node = k < pairs.size() ? pairs[k].from : pairs.back().to;
    diagonal_[k] = masses[node];
    for (std::size_t axis = 0; axis < 2; ++axis) speed_[axis][k] = masses[node] * before[axis * n + node];
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double factor = 2 * time * pairs[k].exchange;
    diagonal_[k] += factor;
    diagonal_[k + 1] += factor;
    coupling_[k] = -factor;
  }
  matrix_.factor({diagonal_, coupling_});
  for (std::vector<double>& speeds : speed_) matrix_.solve(speeds, speeds);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double factor = time * pairs[k].exchange;
    const double x = factor * (speed_[0][k + 1] - speed_[0][k]);
    const double y = factor * (speed_[1][k + 1] - speed_[1][k]);
    push(inverse, pairs[k].from, {x, y}, u);
    push(inverse, pairs[k].to, {-x, -y}, u);
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
