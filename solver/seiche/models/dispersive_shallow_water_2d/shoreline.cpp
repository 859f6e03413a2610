#include "seiche/models/dispersive_shallow_water_2d/shoreline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "seiche/models/dispersive_shallow_water_2d/element.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// Relative round-off of a difference of two values, and of a place times a gradient.
constexpr double noise = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

Shoreline::Shoreline(plan_lattice::Shape shape, const plan_lattice::Sides& sides,
                     std::shared_ptr<const PlanBottom> bottom, Input q)
    : nodes_(shape.nodes()), bottom_(std::move(bottom)), marks_(shape.nodes(), 0) {
  for (const auto& nodes : plan_lattice::shore_edges(shape, sides)) {
    const std::size_t first = std::min(nodes[0], nodes[1]);
    const std::size_t column = std::min(first % (shape.columns + 1), shape.columns - 1);
    const std::size_t row = std::min(first / (shape.columns + 1), shape.rows - 1);
    edges_.push_back({.nodes = nodes, .cell = row * shape.columns + column, .first = ends(nodes, q)});
    for (const std::size_t k : nodes) marks_[k] = 1;
  }
  for (std::size_t k = 0; k < nodes_; ++k) {
    if (marks_[k] != 0) markers_.push_back(k);
  }
}

void Shoreline::land(Output q) const {
  for (const std::size_t k : markers_) q[2 * nodes_ + k] = bottom_->slope(q[k], q[nodes_ + k]).elevation;
}

void Shoreline::tilt_between(Input q0, Input q1, Normals& normals) const {
  for (const std::size_t k : markers_) {
    const Point from{q0[k], q0[nodes_ + k]};
    const Point way = Point{q1[k], q1[nodes_ + k]} - from;
    const auto middle = bottom_->slope(from.x + 0.5 * way.x, from.y + 0.5 * way.y);
    std::array slope{middle.along_x, middle.along_y};
    const double begin = bottom_->slope(from.x, from.y).elevation;
    const double end = bottom_->slope(from.x + way.x, from.y + way.y).elevation;
    const double rounded = std::abs(slope[0] * from.x) + std::abs(slope[1] * from.y);
    complete(slope, {way.x, way.y}, end - begin, noise * (std::abs(begin) + std::abs(end) + rounded));
    const double length = std::sqrt(1 + slope[0] * slope[0] + slope[1] * slope[1]);
    normals[k] = {-slope[0] / length, -slope[1] / length, 1 / length};
  }
}

Shoreline::Ends Shoreline::ends(const std::array<std::size_t, 2>& nodes, Input q) const {
  return {q[nodes[0]], q[nodes_ + nodes[0]], q[nodes[1]], q[nodes_ + nodes[1]]};
}

Shoreline::Moment Shoreline::moment(const Edge& edge, const Ends& at) const {
  const Point first_p{edge.first[0], edge.first[1]}, first_q{edge.first[2], edge.first[3]};
  const Point dp = Point{at[0], at[1]} - first_p;
  const Point dq = Point{at[2], at[3]} - first_q;
  Moment moment;
  for (const auto [s, weight] : gauss_points()) {
    const Point place_p = first_p + s * dp;
    const Point place_q = first_q + s * dq;
    const Point chord = place_q - place_p;
    const auto bottom_p = bottom_->slope(place_p.x, place_p.y);
    const auto bottom_q = bottom_->slope(place_q.x, place_q.y);
    const double a = bottom_p.elevation;
    const double b = bottom_q.elevation;
    // int (1 - t) [(1 - t) a + t b]^2 dt and int t [..]^2 dt.
    const double near_p = a * a / 4 + a * b / 6 + b * b / 12;
    const double near_q = a * a / 12 + a * b / 6 + b * b / 4;
    const double sweep_p = cross(dp, chord);
    const double sweep_q = cross(dq, chord);
    const double half = weight / 2;
    moment.value += half * (near_p * sweep_p + near_q * sweep_q);
    // A change of dp changes the sums by (change of dp) x turn_p, and b(P) by s times it.
    const Point turn_p = near_p * (chord + s * dp) + near_q * s * dq;
    const Point turn_q = near_q * (chord - s * dq) - near_p * s * dp;
    const double by_a = s * ((a / 2 + b / 6) * sweep_p + (a + b) / 6 * sweep_q);
    const double by_b = s * ((a + b) / 6 * sweep_p + (a / 6 + b / 2) * sweep_q);
    moment.gradient[0] += half * (turn_p.y + by_a * bottom_p.along_x);
    moment.gradient[1] += half * (-turn_p.x + by_a * bottom_p.along_y);
    moment.gradient[2] += half * (turn_q.y + by_b * bottom_q.along_x);
    moment.gradient[3] += half * (-turn_q.x + by_b * bottom_q.along_y);
  }
  return moment;
}

Shoreline::Moment Shoreline::moment_between(const Edge& edge, const Ends& from, const Ends& to) const {
  Ends half{}, way{};
  for (std::size_t k = 0; k < way.size(); ++k) {
    half[k] = 0.5 * (from[k] + to[k]);
    way[k] = to[k] - from[k];
  }
  const Moment begin = moment(edge, from);
  const Moment middle = moment(edge, half);
  const Moment end = moment(edge, to);
  Moment result{.value = end.value - begin.value, .gradient = {}};
  double rounded = std::abs(begin.value) + std::abs(end.value);
  for (std::size_t k = 0; k < way.size(); ++k) {
    result.gradient[k] = (begin.gradient[k] + 4 * middle.gradient[k] + end.gradient[k]) / 6;
    rounded += std::abs(end.gradient[k] * to[k]);
  }
  complete(result.gradient, way, result.value, noise * rounded);
  return result;
}

double Shoreline::bottom_moment(Input q, std::span<const char> counted) const {
  double sum = 0;
  for (const Edge& edge : edges_) {
    if (counted.empty() || counted[edge.cell] != 0) sum += moment(edge, ends(edge.nodes, q)).value;
  }
  return sum;
}

/// Pi = -g bottom_moment, so that the force is g times its gradient.
void Shoreline::push(Input q0, Input q1, double gravity, Output forces) const {
  for (const Edge& edge : edges_) {
    const Ends from = ends(edge.nodes, q0);
    const Moment there = q0.data() == q1.data() ? moment(edge, from) : moment_between(edge, from, ends(edge.nodes, q1));
    for (std::size_t k = 0; k < 2; ++k) {
      forces[edge.nodes[k]] += gravity * there.gradient[2 * k];
      forces[nodes_ + edge.nodes[k]] += gravity * there.gradient[2 * k + 1];
    }
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
