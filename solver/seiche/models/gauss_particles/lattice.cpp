#include "seiche/models/gauss_particles/lattice.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

namespace {

/// A number in [0, 1) from two (splitmix64; Steele, Lea & Flood 2014).
double fraction(std::uint64_t seed, double time, std::uint64_t axis) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15U ^ std::bit_cast<std::uint64_t>(time) ^ axis << 62U;
  for (int round = 0; round < 2; ++round) {
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30U) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27U) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
  }
  return static_cast<double>(z >> 11U) * 0x1p-53;
}

long whole_cells(const char* what, double length, double cell) {
  const double count = std::round(length / cell);
  require_that(length > 0 && std::abs(count * cell - length) <= 1e-9 * length,
               "{} = {:.17g} is out of range: must be a positive multiple of the cell, {:g}", what, length, cell);
  return static_cast<long>(count);
}

/// Lines at multiples of the cell from `anchor`, as far as the water and the margin need.
SplineAxis free_axis(int degree, double cell, double anchor, double low, double high) {
  const long first = static_cast<long>(std::floor((low - anchor) / cell)) - free_margin;
  const long last = static_cast<long>(std::floor((high - anchor) / cell)) + free_margin;
  return {degree, anchor + cell * static_cast<double>(first), cell, last - first + 1, Ends::free, first};
}

}  // namespace

void require_continuous_slope(const BottomProfile& profile, double begin, double end) {
  constexpr int intervals = 4096;
  const double width = (end - begin) / intervals;
  double before = profile.slope(begin);
  for (int k = 0; k < intervals; ++k) {
    double left = begin + width * k;
    double right = k + 1 == intervals ? end : left + width;
    const double after = profile.slope(right);
    double from = before;
    double to = after;
    const double rise = std::abs(to - from);
    // Halved towards the larger rise: a jump stays, a continuous change goes on falling.
    if (rise > 1e-6) {
      for (int halving = 0; halving < 24; ++halving) {
        const double middle = 0.5 * (left + right);
        const double between = profile.slope(middle);
        const bool first_half = std::abs(between - from) > std::abs(to - between);
        (first_half ? right : left) = middle;
        (first_half ? to : from) = between;
      }
      require_that(std::abs(to - from) <= 0.5 * rise,
                   "bottom: its slope jumps from {:g} to {:g} at x = {:g}; allowed: a continuous slope", from, to,
                   left);
    }
    before = after;
  }
}

void LatticePlan::check() const {
  require_within("degree of the splines", degree, lowest_degree, highest_degree);
  require_positive("cell_x", cell_x);
  require_not_negative("cell_y", cell_y);
  require_not_negative("period", period);
  if (left_wall) require_finite("left_wall", *left_wall);
  if (right_wall) require_finite("right_wall", *right_wall);
  require_that(period == 0 || !right_wall, "right_wall in a periodic channel; allowed: none");
  if (period > 0) whole_cells("period", period, cell_x);
  if (left_wall && right_wall) whole_cells("right_wall - left_wall", *right_wall - *left_wall, cell_x);
  require_finite("level of the ground", ground.level);
  if (ground.profile) {
    const double reach = 1e3 * cell_x;
    const double begin = std::max(ground.profile->begin(), left_wall.value_or(right_wall.value_or(0) - reach));
    const double end = std::min(ground.profile->end(), right_wall.value_or(begin + (period > 0 ? period : 2 * reach)));
    require_continuous_slope(*ground.profile, begin, end);
  }
}

Lattice LatticePlan::operator()(mechanics::Interval when, const Bounds& water) const {
  const double high_cell = cell_y > 0 ? cell_y : cell_x;
  const auto moved = [&](double cell, std::uint64_t axis) {
    return shift ? cell * fraction(seed, when.middle(), axis) : 0;
  };
  const auto beyond = [&](double length, double cell) {
    return std::max(1L, static_cast<long>(std::floor(length / cell)) + 1 + free_margin);
  };
  const SplineAxis x = [&]() -> SplineAxis {
    if (period > 0) {
      return {degree, left_wall.value_or(0) + moved(cell_x, 0), cell_x, whole_cells("period", period, cell_x),
              Ends::periodic};
    }
    if (left_wall && right_wall) {
      return {degree, *left_wall, cell_x, whole_cells("right_wall - left_wall", *right_wall - *left_wall, cell_x),
              Ends::walls};
    }
    if (left_wall) return {degree, *left_wall, cell_x, beyond(water.right - *left_wall, cell_x), Ends::wall_below};
    if (right_wall) {
      const long cells = beyond(*right_wall - water.left, cell_x);
      return {degree, *right_wall - cell_x * static_cast<double>(cells), cell_x, cells, Ends::wall_above, -cells};
    }
    return free_axis(degree, cell_x, moved(cell_x, 0), water.left, water.right);
  }();
  return {x, bottom ? SplineAxis(degree, 0, high_cell, beyond(water.high, high_cell), Ends::wall_below)
                    : free_axis(degree, high_cell, moved(high_cell, 1), water.low, water.high)};
}

}  // namespace seiche::gauss_particles
