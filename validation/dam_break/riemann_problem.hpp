/// The Riemann problem that the parameters of the case `riemann` set.
#pragma once

#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/case/parameter.hpp"
#include "validation/studies/shallow_water/flow.hpp"

namespace seiche::validation {

exact::Riemann riemann_solution(const Values& values);

/// @throws std::invalid_argument where the jump is not within the channel
FlowProblem riemann_channel(const Values& values);

/// The solution holds until a wave meets an end. The ends move with the water in the particle method, as pistons.
/// @throws std::invalid_argument for a later time
void require_before_ends(const exact::Riemann& solution, const FlowProblem& problem, double time, bool moving_ends);

}  // namespace seiche::validation
