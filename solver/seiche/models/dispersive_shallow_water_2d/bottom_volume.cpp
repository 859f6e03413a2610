#include "seiche/models/dispersive_shallow_water_2d/bottom_volume.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace seiche::dispersive_shallow_water_2d {

BottomVolume::BottomVolume(plan_lattice::Shape shape, std::shared_ptr<const PlanBottom> bottom)
    : shape_(shape),
      bottom_(std::move(bottom)),
      edges_(shape.columns * (shape.rows + 1) + shape.rows * (shape.columns + 1)) {}

BottomVolume::Parts BottomVolume::parts(Places at, std::size_t p, std::size_t q) const {
  const double width = at.x[q] - at.x[p];
  const double height = at.y[q] - at.y[p];
  Parts parts;
  for (const auto [t, weight] : gauss_points()) {
    const auto b = bottom_->integral(at.x[p] + t * width, at.y[p] + t * height);
    parts.value += weight * height * b.value;
    parts.xp += weight * height * (1 - t) * b.elevation;
    parts.xq += weight * height * t * b.elevation;
    parts.yp += weight * height * (1 - t) * b.along_y;
    parts.yq += weight * height * t * b.along_y;
    parts.integral += weight * b.value;
  }
  return parts;
}

BottomVolume::Edge BottomVolume::edge(Places at, std::size_t p, std::size_t q) const {
  const Parts all = parts(at, p, q);
  return {.value = all.value, .xp = all.xp, .yp = all.yp - all.integral, .xq = all.xq, .yq = all.yq + all.integral};
}

BottomVolume::Edge BottomVolume::edge_between(Places q0, Places q1, std::size_t p, std::size_t q) const {
  // The middle of the four coordinates, as two nodes.
  const std::array x{0.5 * (q0.x[p] + q1.x[p]), 0.5 * (q0.x[q] + q1.x[q])};
  const std::array y{0.5 * (q0.y[p] + q1.y[p]), 0.5 * (q0.y[q] + q1.y[q])};
  const Parts begin = parts(q0, p, q);
  const Parts middle = parts({x.data(), y.data()}, 0, 1);
  const Parts end = parts(q1, p, q);
  const auto mean = [&](double Parts::*part) { return (begin.*part + 4 * (middle.*part) + end.*part) / 6; };
  const std::array way{q1.x[p] - q0.x[p], q1.y[p] - q0.y[p], q1.x[q] - q0.x[q], q1.y[q] - q0.y[q]};
  std::array slope{mean(&Parts::xp), mean(&Parts::yp), mean(&Parts::xq), mean(&Parts::yq)};
  // What E grows by, less the mean gradient times the way. Both are the same for B and for its difference from B where
  // a point of the rule is in the middle.
  const double stretch = way[3] - way[1];
  double lacking = 0;
  for (const auto [t, weight] : gauss_points()) {
    const double dx = 0.5 * std::lerp(way[0], way[2], t);
    const double dy = 0.5 * std::lerp(way[1], way[3], t);
    const double place_x = x[0] + t * (x[1] - x[0]);
    const double place_y = y[0] + t * (y[1] - y[0]);
    const double after = bottom_->increment(place_x, place_y, dx, dy);
    const double before = bottom_->increment(place_x, place_y, -dx, -dy);
    lacking += weight * ((y[1] - y[0]) * (after - before) + stretch / 2 * (after + before));
    lacking -= weight * stretch * (after + before) / 6;
  }
  double square = 0;
  for (std::size_t k = 0; k < way.size(); ++k) {
    lacking -= slope[k] * way[k];
    square += way[k] * way[k];
  }
  if (square > 0) {
    for (std::size_t k = 0; k < way.size(); ++k) slope[k] += lacking / square * way[k];
  }
  const double integral = mean(&Parts::integral);
  return {.value = end.value - begin.value,
          .xp = slope[0],
          .yp = slope[1] - integral,
          .xq = slope[2],
          .yq = slope[3] + integral};
}

void BottomVolume::subtract_gradients(Places q0, Places q1, linear::RowBlocks& gradients) {
  const auto between = [&](std::size_t p, std::size_t q) {
    return q0.x == q1.x ? edge(q0, p, q) : edge_between(q0, q1, p, q);
  };
  for (std::size_t j = 0; j <= shape_.rows; ++j) {
    for (std::size_t i = 0; i <= shape_.columns; ++i) {
      const std::size_t k = shape_.node(i, j);
      if (i < shape_.columns) edges_[along_i(i, j)] = between(k, k + 1);
      if (j < shape_.rows) edges_[along_j(i, j)] = between(k, shape_.node(i, j + 1));
    }
  }
  for (std::size_t j = 0; j < shape_.rows; ++j) {
    const linear::RowBlocks::Row row = gradients.row(j);
    for (std::size_t i = 0; i < shape_.columns; ++i) {
      // Around the cell: 0 -> 1, 1 -> 2, and 3 -> 2, 0 -> 3 backwards.
      const Edge& south = edges_[along_i(i, j)];
      const Edge& east = edges_[along_j(i + 1, j)];
      const Edge& north = edges_[along_i(i, j + 1)];
      const Edge& west = edges_[along_j(i, j)];
      const auto subtract = [&](std::size_t corner, double x, double y) {
        row[3 * corner][i] -= x;
        row[3 * corner + 1][i] -= y;
      };
      subtract(0, south.xp - west.xp, south.yp - west.yp);
      subtract(1, south.xq + east.xp, south.yq + east.yp);
      subtract(2, east.xq - north.xq, east.yq - north.yq);
      subtract(3, -north.xp - west.xq, -north.yp - west.yq);
    }
  }
}

double BottomVolume::volume(Places at, std::size_t cell) const {
  const auto [c0, c1, c2, c3] = shape_.corners(cell);
  return edge(at, c0, c1).value + edge(at, c1, c2).value - edge(at, c3, c2).value - edge(at, c0, c3).value;
}

}  // namespace seiche::dispersive_shallow_water_2d
