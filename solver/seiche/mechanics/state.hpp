/// State of a constrained mechanical system between two steps.
#pragma once

#include <array>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::mechanics {

struct State {
  std::vector<double> q;  ///< configuration
  std::vector<double> u;  ///< rates
  double time = 0;
  long steps = 0;  ///< whole steps completed
  /// Multipliers of the last step, at its middle, and of the one before. Single values alternate by O(tau) about the
  /// truth: print nodal_multipliers.
  std::vector<double> multipliers = {};
  std::vector<double> earlier_multipliers = {};
  std::vector<double> earliest_multipliers = {};  ///< of two steps before, for guesses
  /// Rates before the last step, if it was a conservative one, and its length: the next one extrapolates from them.
  std::vector<double> earlier_u = {};
  double earlier_tau = 0;

  /// The last step's multipliers become earlier ones; returns where those of this step belong.
  std::vector<double>& next_multipliers();
  /// The three, from the last step's on: for whoever renumbers cells.
  [[nodiscard]] std::array<std::vector<double>*, 3> all_multipliers() {
    return {&multipliers, &earlier_multipliers, &earliest_multipliers};
  }

  /// Mean of the last two multipliers: their value at the beginning of the last step, for equal steps. The last one
  /// alone after the first step or a change of the constraints.
  [[nodiscard]] std::vector<double> nodal_multipliers() const;
};

/// Sizes and finiteness; throws std::invalid_argument naming the array, the index and the value.
void require_state(const State& state, std::size_t coordinates, std::size_t rates);
/// A step must be finite and positive.
void require_step(double tau);
/// Throws Divergence at the first rate that is not finite.
[[noreturn]] void throw_not_finite(const State& state, Input rates, double place);

/// Index of the first entry that is not finite; size() if there is none. One vectorised pass when all are finite.
std::size_t first_not_finite(Input values);

}  // namespace seiche::mechanics
