#include "seiche/plan_lattice/swept_remap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/plan_lattice/lattice_interpolant.hpp"
#include "seiche/samples.hpp"

namespace seiche::plan_lattice {

Point RowCurve::at(double number) const {
  const auto last = static_cast<double>(x_.size()) - 1;
  const double before = std::clamp(std::floor(number), 0.0, last - 1);
  const auto k = static_cast<std::size_t>(before);
  const double share = number - before;
  const Point straight{std::lerp(x_[k], x_[k + 1], share), std::lerp(y_[k], y_[k + 1], share)};
  const LatticeWeights cubic = cubic_weights(number, x_.size() - 1);
  Point off = -1 * straight;
  for (std::size_t node = 0; node < cubic.count; ++node) {
    off += cubic.weight[node] * Point{x_[cubic.first + node], y_[cubic.first + node]};
  }
  const double most = 0.05 * std::hypot(x_[k + 1] - x_[k], y_[k + 1] - y_[k]);
  const double length = std::hypot(off.x, off.y);
  return straight + (length > most ? most / length : 1.0) * off;
}

Point RowCurve::meet(std::size_t node, Point from, Point to) const {
  const auto off = [&](double number) { return cross(to - from, at(number) - from); };
  const auto here = static_cast<double>(node);
  const double first = off(here);
  if (first == 0) return at(here);
  for (const double reach : {0.5, 1.0, 1.5, 2.0}) {
    for (const double way : {-reach, reach}) {
      const double far = std::clamp(here + way, 0.0, static_cast<double>(x_.size() - 1));
      if (!(off(far) * first < 0)) continue;
      std::uintmax_t evaluations = 100;
      const auto [left, right] = boost::math::tools::toms748_solve(
          off, std::min(here, far), std::max(here, far), boost::math::tools::eps_tolerance<double>(50), evaluations);
      return at(0.5 * (left + right));
    }
  }
  const Point beside = at(here);
  const Point line = to - from;
  return from + dot(line, beside - from) / dot(line, line) * line;
}

void require_convex(const Shape& shape, std::span<const double> x, std::span<const double> y) {
  using namespace bilinear_patch;
  for (std::size_t cell = 0; cell < shape.cells(); ++cell) {
    const auto corners = shape.corners(cell);
    if (smallest(jacobians(at_corners(x, corners), at_corners(y, corners))) > 0) continue;
    const Point corner{x[corners[0]], y[corners[0]]};
    throw mechanics::Infeasible(corner.x, "cell {} at ({:g}, {:g}) would tangle", cell, corner.x, corner.y);
  }
}

double farthest(const Shape& shape, std::span<const double> q, const RezonedPlaces& places) {
  const auto wanted = [&](std::size_t i, std::size_t j) { return places[shape.node(i, j)]; };
  Largest worst;
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    for (std::size_t i = 0; i <= shape.columns; ++i) {
      const std::size_t k = shape.node(i, j);
      const Point there = wanted(i, j);
      double edge = distance(there, i > 0 ? wanted(i - 1, j) : wanted(i + 1, j));
      if (i > 0 && i < shape.columns) edge = std::min(edge, distance(there, wanted(i + 1, j)));
      edge = std::min(edge, distance(there, j > 0 ? wanted(i, j - 1) : wanted(i, j + 1)));
      worst.add(distance({q[k], q[shape.nodes() + k]}, there) / edge);
    }
  }
  return worst.value();
}

}  // namespace seiche::plan_lattice
