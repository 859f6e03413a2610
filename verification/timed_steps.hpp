/// A step function and its state, for seiche::march.
#pragma once

#include <functional>
#include <vector>

#include "seiche/mechanics/state.hpp"
#include "seiche/model.hpp"

namespace seiche::verification {

struct TimedSteps {
  mechanics::State& state;
  std::function<void(double tau)> advance;
  void arrive(double time) const { state.time = time; }
  [[nodiscard]] double time() const { return state.time; }
  [[nodiscard]] long steps() const { return state.steps; }
  [[nodiscard]] static double stable_step() { return 1; }
  [[nodiscard]] static std::vector<Invariant> invariants() { return {}; }
};

}  // namespace seiche::verification
