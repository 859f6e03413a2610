#include "seiche/plan_lattice/lattice_interpolant.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/require.hpp"

namespace seiche::plan_lattice {

namespace {

constexpr double longest = 0.7;    // of Newton's steps [cell]
constexpr double settled = 1e-13;  // the last one
constexpr int most = 20;

}  // namespace

CornerValues corner_values(std::span<const double> values, const Shape& shape, std::size_t cell) {
  const auto [c0, c1, c2, c3] = shape.corners(cell);
  return {values[c0], values[c1], values[c2], values[c3]};
}

CellCoordinates find_in_cell(Point place, const CornerValues& x, const CornerValues& y) {
  CellCoordinates at;
  for (int iteration = 0; iteration < most; ++iteration) {
    const double dx = place.x - x.at(at);
    const double dy = place.y - y.at(at);
    const double xs = x.along_s(at.t), xt = x.along_t(at.s);
    const double ys = y.along_s(at.t), yt = y.along_t(at.s);
    const double jacobian = xs * yt - xt * ys;
    const double ds = std::clamp((dx * yt - dy * xt) / jacobian, -longest, longest);
    const double dt = std::clamp((dy * xs - dx * ys) / jacobian, -longest, longest);
    at = {std::clamp(at.s + ds, -2.0, 3.0), std::clamp(at.t + dt, -2.0, 3.0)};
    if (std::abs(ds) + std::abs(dt) < settled) break;
  }
  return at;
}

namespace {

constexpr double beyond = 0.5;          // of a cell
constexpr double lost = 1;              // of a cell: a place as far as that from all of them
constexpr double settled_step = 1e-12;  // of a cell: Newton's last step

}  // namespace

struct LatticeInterpolant::Stencil {
  LatticeWeights along_i, along_j;

  template <class Take>
  void each(std::size_t row, const Take& take) const {
    for (std::size_t b = 0; b < along_j.count; ++b) {
      for (std::size_t a = 0; a < along_i.count; ++a) take((along_j.first + b) * row + along_i.first + a, a, b);
    }
  }
};

LatticeInterpolant::LatticeInterpolant(Shape shape, std::span<const double> x, std::span<const double> y)
    : shape_(shape), x_(x), y_(y) {
  require_at_least("columns", static_cast<long>(shape.columns), 3);
  require_at_least("rows", static_cast<long>(shape.rows), 3);
}

LatticeInterpolant::Stencil LatticeInterpolant::stencil(const LatticePlace& at) const {
  if (at.cubic) return {cubic_weights(at.i, shape_.columns), cubic_weights(at.j, shape_.rows)};
  return {linear_weights(at.i, shape_.columns), linear_weights(at.j, shape_.rows)};
}

double LatticeInterpolant::value(std::span<const double> values, const LatticePlace& at) const {
  const Stencil nodes = stencil(at);
  double sum = 0;
  double least = values[nodes.along_j.first * (shape_.columns + 1) + nodes.along_i.first];
  double most = least;
  nodes.each(shape_.columns + 1, [&](std::size_t k, std::size_t a, std::size_t b) {
    sum += nodes.along_i.weight[a] * nodes.along_j.weight[b] * values[k];
    least = std::min(least, values[k]);
    most = std::max(most, values[k]);
  });
  return std::clamp(sum, least, most);
}

/// Newton's steps on one stencil's polynomials at a time. False where they lead away.
bool LatticeInterpolant::refine(Point place, LatticePlace& at) const {
  const auto columns = static_cast<double>(shape_.columns);
  const auto rows = static_cast<double>(shape_.rows);
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Stencil nodes = stencil(at);
    Point lacking = place;
    Point along_i;
    Point along_j;
    nodes.each(shape_.columns + 1, [&](std::size_t k, std::size_t a, std::size_t b) {
      const double weight = nodes.along_i.weight[a] * nodes.along_j.weight[b];
      const double by_i = nodes.along_i.slope[a] * nodes.along_j.weight[b];
      const double by_j = nodes.along_i.weight[a] * nodes.along_j.slope[b];
      lacking.x -= weight * x_[k];
      lacking.y -= weight * y_[k];
      along_i.x += by_i * x_[k];
      along_i.y += by_i * y_[k];
      along_j.x += by_j * x_[k];
      along_j.y += by_j * y_[k];
    });
    const double determinant = along_i.x * along_j.y - along_i.y * along_j.x;
    if (!(determinant > 0)) return false;
    const double step_i = (lacking.x * along_j.y - lacking.y * along_j.x) / determinant;
    const double step_j = (along_i.x * lacking.y - along_i.y * lacking.x) / determinant;
    if (!(std::abs(step_i) + std::abs(step_j) < 3)) return false;
    at.i += std::clamp(step_i, -0.5, 0.5);
    at.j += std::clamp(step_j, -0.5, 0.5);
    if (!(at.i > -beyond && at.i < columns + beyond && at.j > -beyond && at.j < rows + beyond)) return false;
    if (std::abs(step_i) + std::abs(step_j) < settled_step) return true;
  }
  return false;
}

/// From cell to cell towards the place, each bilinear.
LatticePlace LatticeInterpolant::find_cell(Point place, LatticePlace guess) const {
  const auto columns = static_cast<double>(shape_.columns);
  const auto rows = static_cast<double>(shape_.rows);
  double cell_i = std::clamp(std::floor(guess.i), 0.0, columns - 1);
  double cell_j = std::clamp(std::floor(guess.j), 0.0, rows - 1);
  double least = std::numeric_limits<double>::infinity();
  LatticePlace best{.i = guess.i, .j = guess.j, .cubic = false};
  for (int walked = 0; walked < 40; ++walked) {
    const std::size_t cell = static_cast<std::size_t>(cell_j) * shape_.columns + static_cast<std::size_t>(cell_i);
    const auto [s, t] = find_in_cell(place, corner_values(x_, shape_, cell), corner_values(y_, shape_, cell));
    const double outside = std::max({-s, s - 1, -t, t - 1, 0.0});
    if (outside < least) {
      least = outside;
      best = {.i = cell_i + s, .j = cell_j + t, .cubic = false};
    }
    if (outside <= 1e-9) break;
    const double next_i = std::clamp(cell_i + (s < 0 ? -1 : s > 1 ? 1 : 0), 0.0, columns - 1);
    const double next_j = std::clamp(cell_j + (t < 0 ? -1 : t > 1 ? 1 : 0), 0.0, rows - 1);
    if (next_i == cell_i && next_j == cell_j) break;
    cell_i = next_i;
    cell_j = next_j;
  }
  if (!(least < lost)) {
    throw mechanics::Infeasible(place.x, "({:g}, {:g}) is on none of the lattice's cells", place.x, place.y);
  }
  return best;
}

LatticePlace LatticeInterpolant::find(Point place, LatticePlace guess) const {
  LatticePlace at{.i = guess.i, .j = guess.j, .cubic = true};
  if (refine(place, at)) return at;
  const LatticePlace cell = find_cell(place, guess);
  at = {.i = cell.i, .j = cell.j, .cubic = true};
  if (refine(place, at) && std::abs(at.i - cell.i) + std::abs(at.j - cell.j) < 0.5) return at;
  return cell;
}

}  // namespace seiche::plan_lattice
