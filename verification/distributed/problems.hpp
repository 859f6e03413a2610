/// Flows that are computed on several processes and on one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "seiche/distributed/distributed_flow.hpp"
#include "seiche/distributed/patches.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/samples.hpp"

namespace seiche::verification::distributed_flows {

namespace plan = dispersive_shallow_water_2d;

struct Problem {
  std::string id;
  std::string what;
  plan::Lattice lattice;
  double step = 0.2;
  long steps = 50;
};

inline double hump(double x, double y) {
  return 0.3 * std::exp(-((x - 8) * (x - 8) + (y - 5) * (y - 5)) / 8);
}

inline Problem box() {
  return {.id = "box",
          .what = "a hump of water 0.3 depths high, off the middle of a box of 40 x 20 cells",
          .lattice = plan::rectangular_lattice(
              {.begin = 0, .end = 20, .south = 0, .north = 10, .columns = 40, .rows = 20, .elevation = hump})};
}

inline Problem shoal() {
  const auto bottom = std::make_shared<PolynomialBottom>(std::vector<PolynomialBottom::Term>{
      {.coefficient = -1}, {.coefficient = 0.02, .x_power = 1}, {.coefficient = 1e-3, .y_power = 2}});
  return {.id = "shoal",
          .what = "the same over the bottom z = -1 + x/50 + y^2/1000",
          .lattice = plan::rectangular_lattice({.begin = 0,
                                                .end = 20,
                                                .south = 0,
                                                .north = 10,
                                                .columns = 40,
                                                .rows = 20,
                                                .elevation = hump,
                                                .bottom = bottom})};
}

/// A wave maker in the west, an oblique wall with a bend in the south.
inline Problem wedge() {
  plan::Lattice lattice = plan::rectangular_lattice(
      {.begin = 0,
       .end = 20,
       .south = 0,
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

/// x, y, z, u, v, w of the nodes of the surface at the end, one after the other; empty but on the first process.
struct Outcome {
  std::vector<double> numbers;
  double first_energy = 0;
  double energy = 0;
  double rim_difference = 0;
  double condition = 0;   ///< of the last step's preconditioned matrix
  double iterations = 0;  ///< per solution
};

template <class Flow>
Outcome outcome(Flow& flow, double step, long steps) {
  const double first_energy = flow.energy();
  for (long n = 0; n < steps; ++n) flow.advance(step);
  const distributed::CellSystem& system = flow.model().system();
  Outcome result{.numbers = {},
                 .first_energy = first_energy,
                 .energy = flow.energy(),
                 .rim_difference = flow.rim_difference(),
                 .condition = system.condition(),
                 .iterations = static_cast<double>(system.iterations()) / static_cast<double>(system.solutions())};
  for (std::size_t number = 0; number < 6; ++number) {
    const auto values = flow.decomposition().gathered(number < 3 ? flow.place(number) : flow.velocity(number - 3));
    result.numbers.insert(result.numbers.end(), values.begin(), values.end());
  }
  return result;
}

/// On all processes.
inline Outcome shared_out(const Problem& problem, double tolerance,
                          mechanics::Stepping stepping = mechanics::Stepping::one_step) {
  distributed::PlanFlow flow(
      problem.lattice.shape, 1,
      [&](const distributed::Patch& patch) { return distributed::part_of(problem.lattice, patch); },
      problem.lattice.sides, {}, {.tolerance = tolerance}, true, stepping);
  return outcome(flow, problem.step, problem.steps);
}

/// On one process, with the direct solver of its model.
inline Outcome alone(const Problem& problem, mechanics::Stepping stepping = mechanics::Stepping::one_step) {
  plan::Flow flow(problem.lattice, {}, {.stepping = stepping}, {.solver = linear::NinePointMethod::banded});
  for (long n = 0; n < problem.steps; ++n) flow.advance(problem.step);
  Outcome result{.energy = flow.energy()};
  for (const auto& values : {flow.x(), flow.y(), flow.z(), flow.u(), flow.v(), flow.w()}) {
    result.numbers.insert(result.numbers.end(), values.begin(), values.end());
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
