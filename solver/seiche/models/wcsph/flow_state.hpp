/// All that decides how a Flow goes on, to the last bit: to be kept, and given to Flow::resume() of a Flow that was
/// made of the same particles, settings and paddles.
#pragma once

#include <vector>

#include "seiche/models/wcsph/flow.hpp"

namespace seiche::wcsph {

struct FlowState {
  /// What the flow was made of besides its particles: settings, spacing, and paddles by their poses at `time`.
  std::vector<double> parameters;
  Particles particles;                           ///< in the order of the last sorting
  std::vector<double> reference_x, reference_z;  ///< of what paddles carry, in the pose {0, 0}; empty without paddles
  /// What the candidate lists were made of at the last sorting. Sums run in the order of the lists: made of later
  /// places they would differ by rounding.
  struct Listed {
    std::vector<double> x, z, density;
    double reserve = 0;  ///< [m]
  } listed;
  double half_travel = 0;  ///< what half a step is going to use of the reserve, by the last one [m]
  double time = 0;
  long steps = 0;
  Extremes extremes;
};

}  // namespace seiche::wcsph
