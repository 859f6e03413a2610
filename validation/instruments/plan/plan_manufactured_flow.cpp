#include "validation/instruments/plan/plan_manufactured_flow.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace seiche::validation {
namespace {

using dispersive_shallow_water_2d::Flow;
using dispersive_shallow_water_2d::Lattice;

double label_of(std::size_t i, std::size_t n, double length) {
  return i == n ? length : length * static_cast<double>(i) / static_cast<double>(n);
}

/// Labels by the places that nodes have at the beginning.
using Labels = std::map<std::pair<double, double>, PlanManufactured::Label>;

/// (integral of square(i, j) over the labels)^(1/2).
template <class Square>
double norm(const Flow& flow, double length, const Square& square) {
  const auto shape = flow.shape();
  double sum = 0;
  double weights = 0;
  for (std::size_t j = 0; j <= shape.rows; ++j) {
    for (std::size_t i = 0; i <= shape.columns; ++i) {
      const double weight = (i % shape.columns == 0 ? 0.5 : 1.0) * (j % shape.rows == 0 ? 0.5 : 1.0);
      sum += weight * square(i, j);
      weights += weight;
    }
  }
  return length * std::sqrt(sum / weights);
}

}  // namespace

long PlanManufacturedRun::steps() const {
  const double spacing = motion.length / static_cast<double>(n);
  return std::max(1L, std::lround(time * static_cast<double>(steps_per_cell) / spacing));
}

Flow plan_manufactured_flow(const PlanManufacturedRun& run) {
  const auto motion = std::make_shared<PlanManufactured>(run.motion);
  const auto labels = std::make_shared<Labels>();
  Lattice lattice{.shape = {run.n, run.n}, .x = {}, .y = {}, .z = {}, .depth = run.motion.depth};
  for (std::size_t j = 0; j <= run.n; ++j) {
    for (std::size_t i = 0; i <= run.n; ++i) {
      const PlanManufactured::Label label{label_of(i, run.n, run.motion.length), label_of(j, run.n, run.motion.length)};
      const auto column = motion->at(label.x, label.y, 0);
      lattice.x.push_back(column.x);
      lattice.y.push_back(column.y);
      lattice.z.push_back(column.depth - run.motion.depth);
      (*labels)[{column.x, column.y}] = label;
    }
  }
  const auto velocity = [&](double x, double y) {
    const auto label = labels->at({x, y});
    const auto column = motion->at(label.x, label.y, 0);
    return dispersive_shallow_water_2d::Velocity{column.u, column.v, column.depth_rate};
  };
  const auto force = [motion, labels](Point place, double time) {
    const auto label = labels->at({place.x, place.y});
    const auto column = motion->at(label.x, label.y, time);
    return Point{column.bx, column.by};
  };
  return Flow(std::move(lattice), velocity, run.scheme,
              {.gravity = run.motion.gravity, .inertia = run.motion.alpha, .tolerance = 1e-11}, {.body_force = force},
              {}, false);
}

PlanManufacturedErrors plan_manufactured_errors(const PlanManufacturedRun& run) {
  Flow flow = plan_manufactured_flow(run);
  const PlanManufactured motion(run.motion);
  const long steps = run.steps();
  PlanManufacturedErrors errors;
  for (long n = 0; n < steps; ++n) flow.advance(run.time / static_cast<double>(steps));
  const auto exact_at = [&](std::size_t i, std::size_t j) {
    return motion.at(label_of(i, run.n, run.motion.length), label_of(j, run.n, run.motion.length), run.time);
  };
  const auto square = [](double a, double b) { return a * a + b * b; };
  errors.position = norm(flow, run.motion.length, [&](std::size_t i, std::size_t j) {
    const std::size_t k = flow.shape().node(i, j);
    const auto column = exact_at(i, j);
    return square(flow.x()[k] - column.x, flow.y()[k] - column.y);
  });
  errors.elevation = norm(flow, run.motion.length, [&](std::size_t i, std::size_t j) {
    return square(flow.z()[flow.shape().node(i, j)] - (exact_at(i, j).depth - run.motion.depth), 0);
  });
  errors.velocity = norm(flow, run.motion.length, [&](std::size_t i, std::size_t j) {
    const std::size_t k = flow.shape().node(i, j);
    const auto column = exact_at(i, j);
    return square(flow.u()[k] - column.u, flow.v()[k] - column.v);
  });
  return errors;
}

PlanManufacturedErrors differences(const Flow& flow, const Flow& other) {
  const double length = flow.model().lattice().x[flow.shape().columns] - flow.model().lattice().x[0];
  const auto difference = [&](auto part) {
    return norm(flow, length, [&](std::size_t i, std::size_t j) {
      const std::size_t k = flow.shape().node(i, j);
      const double d = (flow.*part)()[k] - (other.*part)()[k];
      return d * d;
    });
  };
  return {.position = std::hypot(difference(&Flow::x), difference(&Flow::y)),
          .elevation = difference(&Flow::z),
          .velocity = std::hypot(difference(&Flow::u), difference(&Flow::v))};
}

}  // namespace seiche::validation
