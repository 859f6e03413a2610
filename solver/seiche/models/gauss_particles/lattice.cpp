#include "seiche/models/gauss_particles/lattice.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>

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

constexpr std::size_t most = CellPolynomials::most;
using Polynomial = std::array<double, most>;

/// (a + b z) times a polynomial of lower than the highest degree, added to a sum.
void add_linear_times(double a, double b, const Polynomial& factor, Polynomial& sum) {
  for (std::size_t power = 0; power < most; ++power) sum[power] += a * factor[power];
  for (std::size_t power = 1; power < most; ++power) sum[power] += b * factor[power - 1];
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d{};
  for (std::size_t power = 1; power < most; ++power) d[power - 1] = static_cast<double>(power) * p[power];
  return d;
}

void multiply(const Polynomial& a, const Polynomial& b, std::size_t powers, double* product) {
  for (std::size_t i = 0; i < most; ++i) {
    for (std::size_t k = 0; k < most; ++k) {
      if (i + k < powers) product[i + k] += a[i] * b[k];
    }
  }
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
  require_that(!(period > 0 && right_wall), "right_wall in a periodic channel; allowed: none");
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

SplineAxis::SplineAxis(int degree, double begin, double cell, long cells, Ends ends, long first)
    : degree_(degree), begin_(begin), cell_(cell), cells_(cells), ends_(ends), first_(first) {
  require_within("degree of the splines", degree, lowest_degree, highest_degree);
  require_finite("begin of the lattice", begin);
  require_positive("cell of the lattice", cell);
  require_at_least(periodic() ? "cells of a periodic lattice" : "cells of the lattice", cells,
                   periodic() ? 2 * degree + 1 : 1);
}

std::size_t SplineAxis::kind(long cell) const {
  const long far = degree_ - 1;
  const long below = wall_below() ? std::min(cell, far) : far;
  const long above = wall_above() ? std::min(cells_ - 1 - cell, far) : far;
  return static_cast<std::size_t>(below * degree_ + above);
}

double SplineAxis::knot(long k) const {
  long line = k - degree_;
  if (wall_below()) line = std::max(line, 0L);
  if (wall_above()) line = std::min(line, cells_);
  return static_cast<double>(line);
}

bool SplineAxis::uniform(long from, long to) const {
  return (!wall_below() || from >= 0) && (!wall_above() || to <= cells_);
}

void SplineAxis::extend(long i, long i0, std::span<double> weights) const {
  const auto count = static_cast<long>(weights.size());
  if (uniform(std::min(i, i0) + 1 - degree_, std::max(i, i0 + count - 1))) {
    // Coefficients of polynomials are polynomials of the index: Lagrange's weights.
    for (long a = 0; a < count; ++a) {
      double weight = 1;
      for (long b = 0; b < count; ++b) {
        if (b != a) weight *= static_cast<double>(i - i0 - b) / static_cast<double>(a - b);
      }
      weights[static_cast<std::size_t>(a)] = weight;
    }
    return;
  }
  // Coefficients of 1, z, z^2, ... about the block's middle: mean products of a function's inner knots.
  const double middle = static_cast<double>(i0 - degree_) + 0.5 * static_cast<double>(count + degree_);
  const auto coefficients = [&](long f) {
    Eigen::VectorXd symmetric = Eigen::VectorXd::Zero(count);
    symmetric[0] = 1;
    for (int k = 1; k <= degree_; ++k) {
      for (long power = count - 1; power > 0; --power)
        symmetric[power] += (knot(f + k) - middle) * symmetric[power - 1];
    }
    double binomial = 1;
    for (long power = 1; power < count; ++power) {
      binomial *= static_cast<double>(degree_ - power + 1) / static_cast<double>(power);
      symmetric[power] /= binomial;
    }
    return symmetric;
  };
  Eigen::MatrixXd block(count, count);
  for (long a = 0; a < count; ++a) block.col(a) = coefficients(i0 + a);
  const Eigen::VectorXd solution = block.partialPivLu().solve(coefficients(i));
  std::copy_n(solution.data(), weights.size(), weights.begin());
}

namespace {

CellPolynomials polynomials_of(const SplineAxis& axis, long cell) {
  const int degree = axis.degree();
  const auto order = static_cast<std::size_t>(degree) + 1;
  // Cox's and de Boor's recursion on the polynomials; entry i is that of function cell + i - (degree - k).
  const double middle = static_cast<double>(cell) + 0.5;
  std::array<Polynomial, most> functions{};
  functions[0][0] = 1;
  for (int k = 1; k <= degree; ++k) {
    std::array<Polynomial, most> next{};
    for (int i = 0; i <= k; ++i) {
      const long f = cell + degree - k + i;
      const double low = axis.knot(f);
      const double high = axis.knot(f + k + 1);
      if (i > 0) {
        const double width = axis.knot(f + k) - low;
        const double scale = 2 * k / width;
        add_linear_times(scale * (middle - low), scale, functions[static_cast<std::size_t>(i - 1)],
                         next[static_cast<std::size_t>(i)]);
      }
      if (i < k) {
        const double width = high - axis.knot(f + 1);
        const double scale = 2 * k / width;
        add_linear_times(scale * (high - middle), -scale, functions[static_cast<std::size_t>(i)],
                         next[static_cast<std::size_t>(i)]);
      }
    }
    functions = next;
  }
  CellPolynomials tables;
  const std::size_t powers = 2 * order - 1;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t power = 0; power < order; ++power) tables.function[i * order + power] = functions[i][power];
    const Polynomial slope = derivative(functions[i]);
    for (std::size_t k = 0; k < order; ++k) {
      multiply(slope, functions[k], powers, &tables.mixed_product[(i * order + k) * powers]);
      if (k < i) continue;
      multiply(functions[i], functions[k], powers, &tables.product[pair * powers]);
      multiply(slope, derivative(functions[k]), powers, &tables.derivative_product[pair * powers]);
      ++pair;
    }
  }
  return tables;
}

std::vector<CellPolynomials> all_kinds(int degree) {
  std::vector<CellPolynomials> kinds;
  for (long below = 0; below < degree; ++below) {
    for (long above = 0; above < degree; ++above) {
      kinds.push_back(polynomials_of(SplineAxis(degree, 0, 1, below + above + 1, Ends::walls), below));
    }
  }
  return kinds;
}

}  // namespace

std::span<const CellPolynomials> cell_polynomials(int degree) {
  static const std::array<std::vector<CellPolynomials>, 3> all{all_kinds(2), all_kinds(3), all_kinds(4)};
  return all[static_cast<std::size_t>(degree - lowest_degree)];
}

}  // namespace seiche::gauss_particles
