/// A steady flow that others compute, as a profile of depth and velocity: its depth, its discharge, the place of its
/// jump. Measures do not depend on how densely it is printed; what was never set in motion fails.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "validation/case/claims.hpp"
#include "validation/case/submission.hpp"
#include "validation/steady_flow/settled_flow.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"
#include "validation/studies/shallow_water/profile_points.hpp"

namespace seiche::validation {

struct JudgedSteadyFlow {
  std::string source;  ///< citation
  std::function<State(double x)> exact;
  std::function<double(double x)> level_water;  ///< depth before anything flows: what errors of depth are relative to
  double discharge = 0;                         ///< per unit width [m^2/s]
  double length = 0;                            ///< of the channel [m]
  double tolerance = 0;                         ///< largest mean error of the depth over that of the level water

  struct Jump {
    Front front;
    double sway = 0;  ///< by how much a discharge one per cent off displaces it [m]
  };
  std::optional<Jump> jump = {};
  std::string command = {};  ///< that prints it
};

/// "tolerance" of the depth, in others' results.
Parameter level_tolerance_parameter();

/// What a case with such a flow asks of others, and how it judges them. Judging throws std::invalid_argument as
/// judged_cell() and submitted_points() do.
Submission submission_of(const std::function<JudgedSteadyFlow(const Values&)>& flow_of);

/// How a flow of our own has settled.
struct SettlingRun {
  long particles = 0;
  double time = 0;          ///< [s]
  double depth = 0;         ///< largest [m]
  double celerity = 0;      ///< largest [m/s]
  std::string regime = {};  ///< of several: before the ids of its claims
};

/// The same claims of such a flow, and that of its mass.
void claim_steady_flow(const Claims<Settled>& claims, const JudgedSteadyFlow& flow, const SettlingRun& run);

}  // namespace seiche::validation
