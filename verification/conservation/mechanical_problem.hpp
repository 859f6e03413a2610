/// A mechanical model with the state it starts from, and what tests of all models do with it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"

namespace seiche::verification {

/// The velocity of the start is projected on the constraints.
template <class Model, class Water, class Velocity, class Settings>
struct MechanicalProblem {
  explicit MechanicalProblem(Water water, const Velocity& velocity = {}, Settings settings = {})
      : model(std::move(water), settings), start(model.state(velocity)) {
    mechanics::Start(model).project(start);
  }

  Model model;
  mechanics::State start;
};

/// The ledger of a run of so many steps of length tau.
template <class Problem>
mechanics::InvariantsLedger watched_run(Problem& problem, mechanics::Scheme scheme, double tau, int steps) {
  mechanics::SchemeStepper stepper(problem.model, scheme);
  mechanics::State state = problem.start;
  mechanics::InvariantsWatch watch(problem.model, state);
  for (int n = 0; n < steps; ++n) {
    stepper.step(state, tau);
    watch.record(state);
  }
  return watch.ledger();
}

inline double largest_difference(mechanics::Input a, mechanics::Input b) {
  Worst largest;
  for (std::size_t i = 0; i < a.size(); ++i) largest.add(a[i] - b[i]);
  return largest.value();
}

inline double largest_difference(const mechanics::State& a, const mechanics::State& b) {
  return worst(
      std::array{largest_difference(mechanics::Input(a.q), b.q), largest_difference(mechanics::Input(a.u), b.u)});
}

}  // namespace seiche::verification
