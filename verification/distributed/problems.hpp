/// Flows that are computed on several processes and on one.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "distributed/distributed_flow.hpp"
#include "distributed/patches.hpp"
#include "seiche/exact/model_waves.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/plan/island_flow.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification::distributed_flows {

namespace plan = dispersive_shallow_water_2d;

struct Problem {
  std::string id, what;
  plan::Lattice lattice;
  double step = 0.2;
  long steps = 50;
  plan::VelocityAt velocity = {};
  plan::Window window = {};
  plan::Settings settings = {};
  bool smooth_start = true;
  double depth = 1;  ///< unit of length

  [[nodiscard]] double celerity() const { return std::sqrt(settings.gravity * depth); }
};

inline double hump(double x, double y) {
  return 0.3 * std::exp(-((x - 8) * (x - 8) + (y - 5) * (y - 5)) / 8);
}

inline Problem box() {
  return {.id = "box",
          .what = "a hump of water, a/h = 0.3, away from the middle of a box of 40 x 20 cells",
          .lattice = plan::rectangular_lattice({.end = 20, .north = 10, .columns = 40, .rows = 20, .elevation = hump})};
}

inline Problem shoal() {
  const auto bottom = polynomial_bottom(
      {{.coefficient = -1}, {.coefficient = 0.02, .x_power = 1}, {.coefficient = 1e-3, .y_power = 2}});
  return {.id = "shoal",
          .what = "the same over the bottom z = -1 + x/50 + y^2/1000",
          .lattice = plan::rectangular_lattice(
              {.end = 20, .north = 10, .columns = 40, .rows = 20, .elevation = hump, .bottom = bottom})};
}

/// A wave maker in the west, an oblique wall with a bend in the south.
inline Problem wedge() {
  plan::Lattice lattice = plan::rectangular_lattice(
      {.end = 20,
       .north = 10,
       .columns = 40,
       .rows = 20,
       .sides = {.west = plan_lattice::DrivenSide{.velocity = [](plan_lattice::Place, double time) {
                   const double ramp = std::sin(0.5 * time);
                   return Point{0.1 * ramp * ramp, 0};
                 }}}});
  for (std::size_t k = 0; k < lattice.shape.nodes(); ++k) {
    const double wall = std::max(0.0, lattice.x[k] - 8) * std::tan(20 * std::numbers::pi / 180);
    lattice.y[k] = wall + (10 - wall) * lattice.y[k] / 10;
  }
  return {.id = "wedge",
          .what = "a wave maker in the west and a wall at 20 degrees from x = 8 on in the south",
          .lattice = std::move(lattice)};
}

/// A solitary wave that runs east along a wall at an angle, followed by a window. As validation/mach_reflection, where
/// the wave comes in at the north side: the columns in the west are dropped, water at rest is put before the east side.
inline Problem window() {
  constexpr double amplitude = 0.3;
  constexpr double angle = 20 * std::numbers::pi / 180;
  const auto wave = std::make_shared<exact::SerreSolitary>(amplitude);
  const double speed = wave->speed();
  const auto phase = [=](double x, double y, double time) {
    return x * std::cos(angle) - y * std::sin(angle) - speed * time;
  };
  const auto velocity = [=](double x, double y, double time) {
    const double s = phase(x, y, time);
    const double along = speed * wave->elevation(s) / (1 + wave->elevation(s));
    return plan::Velocity{
        .u = along * std::cos(angle), .v = -along * std::sin(angle), .w = (along - speed) * wave->elevation_slope(s)};
  };
  // The wave is lower than 1e-5 at 14 depths from its crest, which ends 4.4 east of where it meets the wall.
  constexpr double ahead = 20;
  return {.id = "window",
          .what = "a solitary wave of H/h = 0.3 along a wall at 20 degrees, in a window that follows it",
          .lattice = plan::rectangular_lattice(
              {.begin = -12,
               .end = 21,
               .north = 12,
               .columns = 44,
               .rows = 16,
               .elevation = [=](double x, double y) { return wave->elevation(phase(x, y, 0)); },
               .sides = {.north = plan_lattice::DrivenSide{[=](plan_lattice::Place at, double time) {
                           const plan::Velocity given = velocity(at.x, at.y, time);
                           return Point{given.u, given.v};
                         }}}}),
          .step = 0.25,
          .steps = 48,
          .velocity = [=](double x, double y) { return velocity(x, y, 0); },
          .window = {.reach = [=](double time) { return ahead + speed / std::cos(angle) * time; }}};
}

/// A canal z = -1 + (x/10)^2 with a shoreline on either side, whose water is moved up one of them and uneven along it.
inline Problem canal() {
  const auto bottom = polynomial_bottom({{.coefficient = -1}, {.coefficient = 0.01, .x_power = 2}});
  plan::Lattice lattice =
      plan::rectangular_lattice({.begin = -10,
                                 .end = 10,
                                 .north = 8,
                                 .columns = 32,
                                 .rows = 12,
                                 .sides = {.west = plan_lattice::ShoreSide{}, .east = plan_lattice::ShoreSide{}}});
  lattice.bottom = bottom;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const double depth = -bottom->slope(lattice.x[k], 0).elevation;
    lattice.x[k] += 0.5 + 0.3 * std::cos(std::numbers::pi / 8 * lattice.y[k]);
    const bool on_shore = k % 33 % 32 == 0;
    lattice.z[k] = bottom->slope(lattice.x[k], 0).elevation + (on_shore ? 0 : depth);
  }
  return {.id = "canal",
          .what = "water in a parabolic canal, moved up one shore, unevenly",
          .lattice = std::move(lattice),
          .step = 0.1,
          .steps = 60};
}

/// Half of the conical island of Briggs et al. on a coarse lattice, whose south side is the shoreline, until the wave
/// has run up its front; with friction, and the drag that holds the water's edge.
inline Problem island() {
  validation::ConicalIsland::Settings settings{.spacing = 1, .raster = 0.2};
  settings.drag.breaking_slope = 0;  // fronts run through the blocks of several processes
  const auto island = std::make_shared<validation::ConicalIsland>(settings);
  return {.id = "island",
          .what = "a solitary wave that runs up a conical island",
          .lattice = island->lattice(),
          .step = island->step(),
          .steps = 60,
          .velocity = [island](double x, double y) { return island->velocity(x, y); },
          .settings = island->model_settings(),
          .smooth_start = false,
          .depth = 0.32};
}

/// x, y, z, u, v, w of the nodes of the surface at the end, in depths and sqrt(g depth), one after the other; empty but
/// on the first process.
struct Outcome {
  std::vector<double> numbers;
  long shifts = 0;  ///< of a moving window
  double first_energy = 0, energy = 0, rim_difference = 0;
  double condition = 0;   ///< of the last step's preconditioned matrix
  double iterations = 0;  ///< per solution
};

template <class Flow>
Outcome outcome(Flow& flow, double step, long steps, double depth = 1, double celerity = 1) {
  const double first_energy = flow.energy();
  for (long n = 0; n < steps; ++n) flow.advance(step);
  const distributed::CellSystem& system = flow.model().system();
  Outcome result{.numbers = {},
                 .shifts = flow.shifts(),
                 .first_energy = first_energy,
                 .energy = flow.energy(),
                 .rim_difference = flow.rim_difference(),
                 .condition = system.condition(),
                 .iterations = static_cast<double>(system.iterations()) / static_cast<double>(system.solutions())};
  for (std::size_t number = 0; number < 6; ++number) {
    const auto values = flow.decomposition().gathered(number < 3 ? flow.place(number) : flow.velocity(number - 3));
    for (const double value : values) result.numbers.push_back(value / (number < 3 ? depth : celerity));
  }
  return result;
}

/// On all processes.
inline Outcome shared_out(const Problem& problem, double tolerance,
                          mechanics::Stepping stepping = mechanics::Stepping::one_step) {
  plan::Settings settings = problem.settings;
  settings.tolerance = tolerance;
  distributed::PlanFlow flow(
      problem.lattice.shape, 1,
      [&](const distributed::Patch& patch) { return distributed::part_of(problem.lattice, patch); },
      problem.lattice.sides, problem.velocity, settings, problem.smooth_start, stepping, problem.window);
  return outcome(flow, problem.step, problem.steps, problem.depth, problem.celerity());
}

/// On one process, with the direct solver of its model.
inline Outcome alone(const Problem& problem, mechanics::Stepping stepping = mechanics::Stepping::one_step) {
  plan::Settings settings = problem.settings;
  settings.solver = linear::SolverMethod::banded;
  plan::Flow flow(problem.lattice, problem.velocity, {.stepping = stepping}, settings, {}, problem.window,
                  problem.smooth_start);
  const double first_energy = flow.energy();
  for (long n = 0; n < problem.steps; ++n) flow.advance(problem.step);
  Outcome result{.numbers = {}, .shifts = flow.shifts(), .first_energy = first_energy, .energy = flow.energy()};
  for (const auto& values : {flow.x(), flow.y(), flow.z()}) {
    for (const double value : values) result.numbers.push_back(value / problem.depth);
  }
  for (const auto& values : {flow.u(), flow.v(), flow.w()}) {
    for (const double value : values) result.numbers.push_back(value / problem.celerity());
  }
  return result;
}

inline double largest_difference(const Outcome& a, const Outcome& b) {
  Worst largest;
  for (std::size_t k = 0; k < a.numbers.size(); ++k) {
    largest.add(a.numbers[k] - b.numbers[k]);
  }
  return largest.value();
}

/// Largest velocity component.
inline double speed(const Outcome& a) {
  Worst largest;
  for (std::size_t k = a.numbers.size() / 2; k < a.numbers.size(); ++k) {
    largest.add(a.numbers[k]);
  }
  return largest.value();
}

}  // namespace seiche::verification::distributed_flows
