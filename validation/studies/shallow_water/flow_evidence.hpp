/// Claims and figures of a computed flow that are judged and drawn at once.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/studies/shallow_water/contest.hpp"
#include "validation/studies/shallow_water/flow.hpp"
#include "validation/studies/shallow_water/profile_curves.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

/// Claims that mass and momentum (less what passed the ends) are conserved to round-off; ids "mass" and "momentum" with
/// the suffix.
void claim_conservation(evidence::Record& record, const Flow& flow, const std::string& suffix = "");

/// Claim that the jump lies inside a single particle; measures "front_width".
void claim_single_particle(evidence::Record& record, const Flow& flow, const Front& front);

/// Claim that the method's own profile is the exact one to round-off, with mean errors as measurements. For flows of
/// uniform states and jumps.
void claim_exact_profile(evidence::Record& record, const Flow& flow, const FlowProblem& problem, double deepest);

/// Runs a flow through the given times, drawing a row of two panels at each; returns the flow at the last of them.
/// @param progress  told the share of the time that is done
std::unique_ptr<Flow> run_and_draw(evidence::Record& record, const FlowProblem& problem,
                                   const Discretisation& discretisation, const std::vector<double>& times,
                                   const std::string& title, const std::vector<std::string>& atlas,
                                   const std::function<void(double)>& progress);

}  // namespace seiche::validation
