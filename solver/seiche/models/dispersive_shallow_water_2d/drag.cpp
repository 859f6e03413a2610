#include "seiche/models/dispersive_shallow_water_2d/drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "seiche/lattice/water.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::dispersive_shallow_water_2d {

BreakingFronts::BreakingFronts(double slope, double inertia, plan_lattice::Shape shape)
    : slope_(slope), inertia_(inertia), shape_(shape), broke_(slope > 0 ? shape.edges() : 0, 0), breaks_(broke_) {}

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
  const std::size_t first = pairs_.size();
  bool kept = false;
  for (std::size_t k = 0; k < (is_row ? shape_.columns : shape_.rows); ++k) {
    const std::size_t from = is_row ? shape_.node(k, line) : shape_.node(line, k);
    const std::size_t to = is_row ? from + 1 : from + shape_.columns + 1;
    const std::size_t place = is_row ? line * shape_.columns + k : (shape_.rows + 1) * shape_.columns + from;
    const Point way{q[to] - q[from], q[n + to] - q[n + from]};
    const double rise = q[2 * n + to] - q[2 * n + from];
    const bool steep = rise * rise > slope_ * slope_ * dot(way, way);
    kept = kept || steep || broke_[place] != 0;
    pairs_.push_back({.from = from, .to = to, .place = place, .way = way, .rise = rise, .steep = steep});
  }
  if (!kept) return pairs_.resize(first);
  const std::size_t last = is_row ? shape_.rows : shape_.columns;
  const std::array beside{line > 0 ? line - 1 : 0, std::min(line, last - 1)};
  // On a side there is half of the water; its one cell is counted twice.
  const double share = beside[0] == beside[1] ? 1 : 2;
  for (std::size_t k = 0; k < pairs_.size() - first; ++k) {
    Pair& pair = pairs_[first + k];
    double water = 0;
    double area = 0;
    for (const std::size_t strip : beside) {
      const std::size_t cell = is_row ? strip * shape_.columns + k : k * shape_.columns + strip;
      water += volumes[cell] / 4;
      area += cell_area(shape_, q, q.subspan(n), cell) / 4;
    }
    pair.depth = water / area;
    pair.exchange = share * water * (2 * std::sqrt(inertia_ * pair.depth) * pair.depth) / dot(pair.way, pair.way);
  }
  lines_.push_back(pairs_.size());
}

void BreakingFronts::find(double gravity, mechanics::Input u) const {
  constexpr double least = 0.0015;
  const std::size_t n = shape_.nodes();
  const auto comes_nearer = [&](const Pair& pair) {
    const Point nearer{u[pair.from] - u[pair.to], u[n + pair.from] - u[n + pair.to]};
    return dot(nearer, pair.way) > least * dot(pair.way, pair.way) * std::sqrt(gravity / pair.depth);
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
      const auto pairs = std::span(pairs_).subspan(first, behind - first);
      const double part = steep || goes_on ? damping(pairs) : 0.0;
      if (part > 0) {
        fronts_.push_back({pairs, part});
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
  for (const auto& [pairs, damping] : fronts_) mix(pairs, h * std::sqrt(gravity) * damping, masses, inverse, u);
}

void BreakingFronts::shift_east() {
  if (broke_.empty()) return;
  const std::span all(broke_);
  const auto shift = [](std::span<char> places, std::size_t length) {
    lattice::shift_rows(places, length);
    for (std::size_t k = length - 1; k < places.size(); k += length) places[k] = 0;
  };
  const std::size_t along = (shape_.rows + 1) * shape_.columns;
  shift(all.first(along), shape_.columns);
  shift(all.subspan(along), shape_.columns + 1);
}

/// The mean of a step's velocities gets half of what those at its end get, (M + 2 h L) u' = M u, L the pairs: a front
/// along a row and one across take no more than all between them, and neither has to come first.
void BreakingFronts::mix(std::span<const Pair> pairs, double time, std::span<const double> masses,
                         const InverseMasses& inverse, mechanics::Output u) const {
  const std::size_t n = masses.size();
  const std::size_t count = pairs.size() + 1;
  diagonal_.resize(count);
  coupling_.resize(count);
  for (std::vector<double>& speeds : speed_) speeds.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t node = k < pairs.size() ? pairs[k].from : pairs.back().to;
    diagonal_[k] = masses[node];
    for (std::size_t axis = 0; axis < 2; ++axis) speed_[axis][k] = masses[node] * before_[axis * n + node];
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
    const Point impulse =
        time * pairs[k].exchange * Point{speed_[0][k + 1] - speed_[0][k], speed_[1][k + 1] - speed_[1][k]};
    push(inverse, pairs[k].from, impulse, u);
    push(inverse, pairs[k].to, -1 * impulse, u);
  }
}

Drag::Drag(DragSettings settings, const Lattice& lattice, double inertia)
    : settings_(settings), shape_(lattice.shape), breaking_(settings.breaking_slope, inertia, lattice.shape) {
  require_ranges(settings);
  require_that(settings.shore_rate == 0 || std::holds_alternative<plan_lattice::ShoreSide>(lattice.sides.south),
               "shore_rate without a shoreline on the south side; allowed: 0");
  for (std::size_t k = 0; settings.absorption && k < lattice.shape.nodes(); ++k) {
    absorption_.push_back(settings.absorption({lattice.x[k], lattice.y[k]}));
    require_not_negative("absorption", absorption_.back());
  }
}

void Drag::measure(const Lattice& lattice, std::span<const double> volumes, mechanics::Input q, bool new_step) {
  const std::size_t n = lattice.shape.nodes();
  if (settings_.manning > 0) {
    depth_.assign(n, 0.0);
    area_.assign(n, 0.0);
    for (std::size_t cell = 0; cell < lattice.shape.cells(); ++cell) {
      const double area = cell_area(lattice.shape, q, q.subspan(n), cell);
      for (const std::size_t k : lattice.shape.corners(cell)) {
        depth_[k] += volumes[cell];
        area_[k] += area;
      }
    }
    for (std::size_t k = 0; k < n; ++k) depth_[k] /= area_[k];
  }
  if (settings_.shore_rate > 0) {
    along_.resize(shape_.columns + 1);
    for (std::size_t i = 1; i < shape_.columns; ++i) {
      const Point normal = plan_lattice::chord_normal({i - 1, i + 1}, q.first(n), q.subspan(n, n));
      along_[i] = {-normal.y, normal.x};
    }
  }
  if (settings_.breaking_slope > 0 && new_step) breaking_.measure(volumes, q);
}

void Drag::slow(std::span<const double> masses, const InverseMasses& inverse, double gravity, double h,
                mechanics::Output u) const {
  const std::size_t n = masses.size();
  if (settings_.manning > 0) {
    for (std::size_t k = 0; k < n; ++k) {
      const double rate =
          gravity * settings_.manning * settings_.manning * std::hypot(u[k], u[n + k]) / std::pow(depth_[k], 4.0 / 3);
      const double lost = -masses[k] * h * rate / (1 + h * rate);
      push(inverse, k, {lost * u[k], lost * u[n + k]}, u);
    }
  }
  if (settings_.shore_rate > 0) {
    // Between the ends, which lie on walls.
    for (std::size_t i = 1; i < shape_.columns; ++i) {
      const std::size_t beside = i + shape_.columns + 1;
      const Point t = along_[i];
      const auto inverse_along = [&](std::size_t k) {
        return inverse.xx[k] * t.x * t.x + 2 * inverse.xy[k] * t.x * t.y + inverse.yy[k] * t.y * t.y;
      };
      const double difference = (u[i] - u[beside]) * t.x + (u[n + i] - u[n + beside]) * t.y;
      const double part = h * settings_.shore_rate / (1 + h * settings_.shore_rate);
      const double impulse = part * difference / (inverse_along(i) + inverse_along(beside));
      push(inverse, i, -impulse * t, u);
      push(inverse, beside, impulse * t, u);
    }
  }
  if (settings_.lattice_rate > 0) slow_pattern(masses, inverse, h, u);
  if (settings_.breaking_slope > 0) breaking_.exchange(masses, inverse, gravity, h, u);
}

void Drag::absorb(double h, mechanics::Output u) const {
  const std::size_t n = u.size() / 3;
  for (std::size_t k = 0; k < absorption_.size(); ++k) {
    const double left = 1 / (1 + h * absorption_[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) u[axis * n + k] *= left;
  }
}

// All pairs of neighbouring cells at once, each so much that what a node gets from all of them takes energy: by the
// largest of its nodes' sums of |weight| |weights| / (mass lightness), Gershgorin's bound of the pairs' sum.
void Drag::slow_pattern(std::span<const double> masses, const InverseMasses& inverse, double h,
                        mechanics::Output u) const {
  constexpr std::array weight{1.0, -1.0, -2.0, 2.0, 1.0, -1.0};
  constexpr double weights = 8;  // sum of |weight|
  const std::size_t n = masses.size();
  // The whole pattern sees its nodes in six pairs along each direction, 32/3 times what one pair does.
  const double part = 3.0 / 32 * h * settings_.lattice_rate;
  // act(the six nodes of a pair)
  const auto in_pairs = [&](const auto& act) {
    const auto pair = [&](std::size_t k, std::size_t along, std::size_t across) {
      act(std::array{k, k + across, k + along, k + along + across, k + 2 * along, k + 2 * along + across});
    };
    for (std::size_t j = 0; j < shape_.rows; ++j) {
      for (std::size_t i = 0; i + 1 < shape_.columns; ++i) pair(shape_.node(i, j), 1, shape_.columns + 1);
    }
    for (std::size_t j = 0; j + 1 < shape_.rows; ++j) {
      for (std::size_t i = 0; i < shape_.columns; ++i) pair(shape_.node(i, j), shape_.columns + 1, 1);
    }
  };
  const auto lightness_of = [&](const auto& nodes) {
    double lightness = 0;
    for (std::size_t c = 0; c < 6; ++c) lightness += weight[c] * weight[c] / masses[nodes[c]];
    return lightness;
  };
  share_.assign(n, 0.0);
  in_pairs([&](const auto& nodes) {
    const double share = weights / lightness_of(nodes);
    for (std::size_t c = 0; c < 6; ++c) share_[nodes[c]] += std::abs(weight[c]) * share / masses[nodes[c]];
  });
  impulse_.assign(n, {});
  in_pairs([&](const auto& nodes) {
    double share = 0;
    Point difference;
    for (std::size_t c = 0; c < 6; ++c) {
      share = std::max(share, share_[nodes[c]]);
      difference += weight[c] * Point{u[nodes[c]], u[n + nodes[c]]};
    }
    const double taken = -part / (1 + part * share) / lightness_of(nodes);
    for (std::size_t c = 0; c < 6; ++c) impulse_[nodes[c]] += weight[c] * taken * difference;
  });
  for (std::size_t k = 0; k < n; ++k) push(inverse, k, impulse_[k], u);
}

}  // namespace seiche::dispersive_shallow_water_2d
