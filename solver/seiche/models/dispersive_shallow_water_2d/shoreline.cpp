#include "seiche/models/dispersive_shallow_water_2d/shoreline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "seiche/models/dispersive_shallow_water_2d/element.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// Relative round-off of a difference of two values. What is lacking to a discrete gradient beyond it is added; less,
/// divided by a short way, would become a force.
constexpr double noise = 8 * std::numeric_limits<double>::epsilon();

/// How much of a quantity with this gradient the rounding of a place is worth, over the relative rounding.
double rise(Point gradient, Point place) {
  return std::abs(gradient.x * place.x) + std::abs(gradient.y * place.y);
}

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
    Point slope{middle.along_x, middle.along_y};
    const double begin = bottom_->slope(from.x, from.y).elevation;
    const double end = bottom_->slope(from.x + way.x, from.y + way.y).elevation;
    const double lacking = end - begin - dot(slope, way);
    const double roundoff = noise * (std::abs(begin) + std::abs(end) + rise(slope, from));
    if (std::abs(lacking) > roundoff) slope += lacking / dot(way, way) * way;
    const double length = std::sqrt(1 + dot(slope, slope));
    normals[k] = {-slope.x / length, -slope.y / length, 1 / length};
  }
}

Shoreline::Ends Shoreline::ends(const std::array<std::size_t, 2>& nodes, Input q) const {
  const auto [p, r] = nodes;
  return {Point{q[p], q[nodes_ + p]}, Point{q[r], q[nodes_ + r]}};
}

Shoreline::Moment Shoreline::moment(const Edge& edge, const Ends& at) const {
  const Point dp = at[0] - edge.first[0];
  const Point dq = at[1] - edge.first[1];
  Moment moment;
  for (const auto [s, weight] : gauss_points()) {
    const Point place_p = edge.first[0] + s * dp;
    const Point place_q = edge.first[1] + s * dq;
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
    moment.gradient[0] += half * Point{turn_p.y + by_a * bottom_p.along_x, -turn_p.x + by_a * bottom_p.along_y};
    moment.gradient[1] += half * Point{turn_q.y + by_b * bottom_q.along_x, -turn_q.x + by_b * bottom_q.along_y};
  }
  return moment;
}

Shoreline::Moment Shoreline::moment_between(const Edge& edge, const Ends& from, const Ends& to) const {
  const Moment begin = moment(edge, from);
  const Moment middle = moment(edge, {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])});
  const Moment end = moment(edge, to);
  Moment result{.value = end.value - begin.value, .gradient = {}};
  double done = 0;
  double square = 0;
  Ends way{};
  for (std::size_t k = 0; k < 2; ++k) {
    result.gradient[k] = {(begin.gradient[k].x + 4 * middle.gradient[k].x + end.gradient[k].x) / 6,
                          (begin.gradient[k].y + 4 * middle.gradient[k].y + end.gradient[k].y) / 6};
    way[k] = to[k] - from[k];
    done += dot(result.gradient[k], way[k]);
    square += dot(way[k], way[k]);
  }
  const double lacking = result.value - done;
  double rounded = std::abs(begin.value) + std::abs(end.value);
  for (std::size_t k = 0; k < 2; ++k) rounded += rise(end.gradient[k], to[k]);
  if (std::abs(lacking) > noise * rounded) {
    for (std::size_t k = 0; k < 2; ++k) result.gradient[k] += lacking / square * way[k];
  }
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
      forces[edge.nodes[k]] += gravity * there.gradient[k].x;
      forces[nodes_ + edge.nodes[k]] += gravity * there.gradient[k].y;
    }
  }
}

}  // namespace seiche::dispersive_shallow_water_2d
