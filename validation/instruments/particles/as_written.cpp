#include "validation/instruments/particles/as_written.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/shallow_water/relations.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation {

using shallow_water_particles::End, shallow_water_particles::Ends, shallow_water_particles::Piston,
    shallow_water_particles::Vacuum, shallow_water_particles::Wall;

namespace {

constexpr double equal_densities = 1e-9;
constexpr double touching = 1e-11;
constexpr int sweeps_of_a_particle = 10;  // the far side moves by one particle a sweep

bool denser(double a, double b) {
  return a > b * (1 + equal_densities);
}

}  // namespace

AsWritten::AsWritten(const shallow_water_particles::Particles& initial, Ends ends, double gravity)
    : row_{.left = {initial.edge.begin(), initial.edge.end() - 1},
           .right = {initial.edge.begin() + 1, initial.edge.end()},
           .mass = {initial.mass.begin(), initial.mass.end()},
           .velocity = {initial.velocity.begin(), initial.velocity.end()}},
      ends_(std::move(ends)),
      gravity_(gravity) {
  impulse_.add(momentum());
}

std::optional<double> AsWritten::end_velocity(bool right, double time) const {
  const End& end = right ? ends_.right : ends_.left;
  if (const auto* piston = std::get_if<Piston>(&end)) return piston->velocity(time);
  return std::holds_alternative<Wall>(end) ? std::optional(0.0) : std::nullopt;
}

std::vector<double> AsWritten::edges() const {
  std::vector<double> edges = row_.left;
  edges.push_back(row_.right.back());
  return edges;
}

bool AsWritten::rebuild(Row& row, std::size_t i) {
  const std::size_t k = i + 1;
  const bool overlap = row.right[i] > row.left[k];
  const bool right_one = overlap ? !denser(row.depth(k), row.depth(i)) : row.velocity[k] > row.velocity[i];
  if (right_one) {
    const double cap = row.depth(i);
    row.left[k] = row.right[i];
    if (!(row.right[k] > row.left[k]) || denser(row.depth(k), cap)) row.right[k] = row.left[k] + row.mass[k] / cap;
  } else {
    const double cap = row.depth(k);
    row.right[i] = row.left[k];
    if (!(row.right[i] > row.left[i]) || denser(row.depth(i), cap)) row.left[i] = row.right[i] - row.mass[i] / cap;
  }
  return right_one;
}

double AsWritten::shortest_crossing() const {
  const auto crossing = [&](std::size_t i) { return mass(i) / depth(i) / shallow_water::celerity(gravity_, depth(i)); };
  return over<Smallest>(indices(size()), crossing).value();
}

void AsWritten::advance(double tau) {
  largest_courant_.add(tau / shortest_crossing());
  Row row = row_;
  const std::size_t n = size();
  const std::optional<double> at_left = end_velocity(false, time_ + tau / 2);
  const std::optional<double> at_right = end_velocity(true, time_ + tau / 2);
  const double near = touching * (row.right.back() - row.left.front());
  // Step 1: the motion.
  for (std::size_t i = 0; i < n; ++i) {
    row.left[i] += tau * row.velocity[i];
    row.right[i] += tau * row.velocity[i];
  }
  // Step 2: the rearrangement. At a wall and at a piston there is nothing to rebuild.
  const auto hold_ends = [&] {
    if (at_left) row.left.front() = row_.left.front() + tau * *at_left;
    if (at_right) row.right.back() = row_.right.back() + tau * *at_right;
  };
  std::vector<char> right_one(n, 0);
  int sweep = 0;
  for (bool touch = false; !touch; ++sweep) {
    if (sweep == sweeps_of_a_particle * static_cast<int>(n)) {
      throw Divergence(fmt::format("pairs do not touch after {} sweeps", sweep), time_, steps_, row_.left.front());
    }
    hold_ends();
    touch = true;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      if (std::abs(row.right[i] - row.left[i + 1]) <= near) continue;
      touch = false;
      right_one[i] = rebuild(row, i) ? 1 : 0;
    }
  }
  hold_ends();
  for (std::size_t i = 0; i < n; ++i) {
    if (!(row.right[i] > row.left[i])) {
      throw Divergence(fmt::format("no room for particle {}", i), time_, steps_, row_.left[i]);
    }
  }
  // Step 3: pressures of the new depths, and the velocities that follow.
  std::vector<double> thrust(n + 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    thrust[i + 1] = shallow_water::thrust(gravity_, row.depth(right_one[i] != 0 ? i + 1 : i));
  }
  const auto at_end = [&](const End& end, std::size_t i) {
    return std::holds_alternative<Vacuum>(end) ? 0.0 : shallow_water::thrust(gravity_, row.depth(i));
  };
  thrust.front() = at_end(ends_.left, 0);
  thrust.back() = at_end(ends_.right, n - 1);
  for (std::size_t i = 0; i < n; ++i) row.velocity[i] += tau * (thrust[i] - thrust[i + 1]) / row.mass[i];
  double impulse = tau * (thrust.front() - thrust.back());
  const auto follow = [&](const End& end, std::size_t i, std::optional<double> velocity) {
    if (!std::holds_alternative<Piston>(end)) return;
    impulse += row.mass[i] * (*velocity - row.velocity[i]);
    row.velocity[i] = *velocity;
  };
  follow(ends_.left, 0, at_left);
  follow(ends_.right, n - 1, at_right);
  std::swap(row_, row);
  impulse_.add(impulse);
  time_ += tau;
  ++steps_;
}

}  // namespace seiche::validation
