/// Why measured run-up on mild slopes lies below the model: the same waves without friction, by the Euler equations,
/// and small waves, by the exact solution of the shallow-water equations.
#pragma once

#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/parameter.hpp"

namespace seiche::validation {

/// A wave on a slope of more than cotangent 2, with its run-up as measured and by the one-dimensional model with the
/// kinetic energy of Green and Naghdi, as fine as it was computed.
struct MeasuredWave {
  double cot_slope = 0, amplitude = 0, measured = 0, green_naghdi = 0;
};

/// Run-up by the Euler equations on the two-dimensional Lagrangian mesh, extrapolated to fine cells.
struct EulerRunup : MeasuredWave {
  double runup = 0;        ///< from the two finest of three meshes, first order
  double uncertainty = 0;  ///< what the last halving of the cells changes of it
};

/// Of those that do not break on their way up.
std::vector<EulerRunup> euler_runups(const std::vector<MeasuredWave>& waves);

/// A wave so small that shallow-water theory holds to its height.
struct LowWave {
  static constexpr double amplitude = 0.005;
  double cot_slope = 0;
  double frank = 0;  ///< run-up with the thesis's kinetic energy, tip V/6
  double green_naghdi = 0;
  double exact = 0;  ///< of the shallow-water equations
};
std::vector<LowWave> small_waves(const Values& values, double spacing);

struct MildSlopes {
  std::vector<LowWave> small;
  std::vector<EulerRunup> euler;
};
/// What holds of run-up on mild slopes without friction.
void claim_mild_slopes(const Claims<MildSlopes>& claims);
void show_mild_slopes(const MildSlopes& mild, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
