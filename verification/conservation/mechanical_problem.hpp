/// A mechanical model with the state it starts from, and what tests of all models do with it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"

namespace seiche::verification {

/// A first velocity: sheared, turned and bent.
inline Point stirring(Point r) {
  return {0.4 * r.x - 0.7 * r.y + 0.1 * std::sin(2 * r.y) + 0.3, 0.5 * r.x - 0.4 * r.y + 0.1 * std::cos(3 * r.x) - 0.2};
}

/// The velocity of the start is projected on the constraints.
template <class Model, class Water, class Velocity, class Settings>
struct MechanicalProblem {
  explicit MechanicalProblem(Water water, const Velocity& velocity = {}, Settings settings = {})
      : model(std::move(water), settings), start(model.state(velocity)) {
    mechanics::Start(model).project(start);
  }
  /// Of a cell, mean.
  [[nodiscard]] double cell() const { return model.mass() / static_cast<double>(model.constraints()); }

  Model model;
  mechanics::State start;
};

/// The ledger of a run of so many steps of length tau.
/// @param after  after(state) looks at each step's end
template <class Problem, class After = void (*)(const mechanics::State&)>
mechanics::InvariantsLedger watched_run(
    Problem&& problem, mechanics::Scheme scheme, double tau, long steps,
    After&& after = [](const mechanics::State&) {}) {
  mechanics::SchemeStepper stepper(problem.model, scheme);
  mechanics::State state = problem.start;
  mechanics::InvariantsWatch watch(problem.model, state);
  for (long n = 0; n < steps; ++n) {
    stepper.step(state, tau);
    watch.record(state);
    after(state);
  }
  return watch.ledger();
}

/// An entry of a ledger that stays as it was. @param over  what its defect is compared with
struct Kept {
  std::string entry;
  evidence::Criterion limit;
  double over = 1;
};

inline void conserves(Check& check, const std::string& flow, const mechanics::InvariantsLedger& ledger,
                      const std::vector<Kept>& all) {
  for (const auto& [entry, limit, over] : all) {
    check.holds(flow + ": " + entry + " to round-off.", {ledger.largest_defect(entry) / over}, limit);
  }
}

inline double largest_difference(const mechanics::State& a, const mechanics::State& b) {
  return worst(std::array{largest_difference(a.q, b.q), largest_difference(a.u, b.u)});
}

/// What is left after so many steps, reversal of the velocities, as many steps and another reversal.
template <class Model>
double there_and_back(Model& model, const mechanics::State& start, mechanics::Scheme scheme, double tau, int steps) {
  mechanics::SchemeStepper<Model> stepper(model, scheme);
  mechanics::State state = start;
  for (int turn = 0; turn < 2; ++turn) {
    for (int n = 0; n < steps; ++n) stepper.step(state, tau);
    for (double& u : state.u) u = -u;
  }
  return largest_difference(state, start);
}

}  // namespace seiche::verification
