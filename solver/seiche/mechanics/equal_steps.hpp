/// Equal steps to a given time.
#pragma once

#include <functional>

#include "seiche/mechanics/state.hpp"

namespace seiche::mechanics {

/// Equal steps of at most tau until `time`, which is hit exactly: advance(length) takes one, after_step (or none) is
/// called after each. Only the last time is set, to what rounding took from it: the steps are those of a loop of
/// advance(length), byte for byte. Throws std::invalid_argument for a time before the state's, and for tau.
void equal_steps_to(State& state, double time, double tau, const std::function<void()>& after_step,
                    const std::function<void(double length)>& advance);

}  // namespace seiche::mechanics
