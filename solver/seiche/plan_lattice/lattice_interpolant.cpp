#include "seiche/plan_lattice/lattice_interpolant.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/require.hpp"

namespace seiche::plan_lattice {

namespace {

constexpr double settled = 1e-12;  // of a cell: Newton's last step

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

/// Newton's steps on one stencil's polynomials at a time. Cubics are given up where they lead away or out by half a
/// cell; bilinear cells lead on along the sides, and find what is outside by less than a cell.
bool LatticeInterpolant::refine(Point place, LatticePlace& at) const {
  const double beyond = at.cubic ? 0.5 : 1;
  const auto stays = [&](double& coordinate, double step, std::size_t cells) {
    const double last = static_cast<double>(cells) + beyond;
    const double to = coordinate + std::clamp(step, -0.5, 0.5);
    coordinate = at.cubic ? to : std::clamp(to, -beyond, last);
    return to > -beyond && to < last;
  };
  for (int iteration = 0; iteration < (at.cubic ? 12 : 80); ++iteration) {
    const Stencil nodes = stencil(at);
    Point lacking = place;
    Point along_i;
    Point along_j;
    nodes.each(shape_.columns + 1, [&](std::size_t k, std::size_t a, std::size_t b) {
      const Point node{x_[k], y_[k]};
      lacking = lacking - nodes.along_i.weight[a] * nodes.along_j.weight[b] * node;
      along_i += nodes.along_i.slope[a] * nodes.along_j.weight[b] * node;
      along_j += nodes.along_i.weight[a] * nodes.along_j.slope[b] * node;
    });
    const double determinant = cross(along_i, along_j);
    const double step_i = cross(lacking, along_j) / determinant;
    const double step_j = cross(along_i, lacking) / determinant;
    const double step = std::abs(step_i) + std::abs(step_j);
    if (!(determinant > 0) || (at.cubic && !(step < 3))) return false;
    const bool inside_i = stays(at.i, step_i, shape_.columns);
    const bool inside = stays(at.j, step_j, shape_.rows) && inside_i;
    if (at.cubic && !inside) return false;
    if (inside && step < settled) return true;
  }
  return false;
}

LatticePlace LatticeInterpolant::find(Point place, LatticePlace guess) const {
  LatticePlace at{.i = guess.i, .j = guess.j, .cubic = true};
  if (refine(place, at)) return at;
  LatticePlace cell{.i = guess.i, .j = guess.j, .cubic = false};
  if (!refine(place, cell)) {
    throw mechanics::Infeasible(place.x, "({:g}, {:g}) is on none of the lattice's cells", place.x, place.y);
  }
  at = {.i = cell.i, .j = cell.j, .cubic = true};
  return refine(place, at) && std::abs(at.i - cell.i) + std::abs(at.j - cell.j) < 0.5 ? at : cell;
}

}  // namespace seiche::plan_lattice
