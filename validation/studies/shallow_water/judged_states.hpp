/// A flow that is, at one time, two uniform states with what became of their meeting between them: a dam break, a bore,
/// one that met a wall or another bore. Others are asked for it, and they and our own schemes are judged by the same
/// claims.
#pragma once

#include <functional>
#include <vector>

#include "validation/case/claims.hpp"
#include "validation/case/submission.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"
#include "validation/studies/shallow_water/riemann_profile.hpp"

namespace seiche::validation {

struct JudgedStates {
  exact::Riemann solution;
  double since = 0;  ///< they met [s]
  double start = 0;  ///< of the channel [m]
  double end = 1;    ///< [m]
  long cells = 100;  ///< over the channel, of a solver that does not say how many it has

  [[nodiscard]] double length() const { return end - start; }
};

/// The profile of depth and velocity that others are asked for.
std::vector<WantedTable> wanted_states(const JudgedStates& states);

/// What a case with such a flow asks of others, and how it judges them. Judging throws std::invalid_argument as
/// judged_cell() and submitted_points() do.
Submission submission_of(const std::function<JudgedStates(const Values&)>& states_of);

/// The same claims of a flow of our own. @param cell  [m]; viscosity: see riemann_requirements()
void claim_states(const Claims<FlowRun>& claims, const JudgedStates& states, double cell, double viscosity = 1);

}  // namespace seiche::validation
