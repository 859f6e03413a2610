/// Why measured run-up on mild slopes lies below the model: the same waves without friction, by the Euler equations,
/// and small waves, by the exact solution of the shallow-water equations.
#pragma once

#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/claims.hpp"
#include "validation/run_up/frank_runup.hpp"

namespace seiche::validation {

/// Run-up by the Euler equations on the two-dimensional Lagrangian mesh, extrapolated to fine cells.
struct EulerRunup {
  double cot_slope = 0;
  double amplitude = 0;
  double measured = 0;
  double green_naghdi = 0;  ///< by the one-dimensional model, as fine as it was computed
  double runup = 0;         ///< from the two finest of three meshes, first order
  double uncertainty = 0;   ///< what the last halving of the cells changes of it
};

/// Of the measured waves on slopes of more than cotangent 2 that do not break on their way up.
std::vector<EulerRunup> euler_runups(const std::vector<ComputedRunup>& rows);

/// A wave so small that shallow-water theory holds to its height.
struct SmallWave {
  static constexpr double amplitude = 0.005;
  double cot_slope = 0;
  double frank = 0;  ///< run-up with the thesis's kinetic energy, tip V/6
  double green_naghdi = 0;
  double exact = 0;  ///< of the shallow-water equations
};
std::vector<SmallWave> small_waves(const Values& values, double spacing);

struct MildSlopes {
  std::vector<SmallWave> small;
  std::vector<EulerRunup> euler;
};
/// What holds of run-up on mild slopes without friction.
void claim_mild_slopes(const Claims<MildSlopes>& claims);
void show_mild_slopes(const MildSlopes& mild, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
