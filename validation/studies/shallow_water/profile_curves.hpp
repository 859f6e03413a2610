/// Shallow-water profiles as curves to be drawn.
#pragma once

#include <vector>

#include "validation/studies/shallow_water/flow.hpp"

namespace seiche::validation {

/// Depth and velocity along x.
struct ExactCurve {
  std::vector<double> x;
  std::vector<double> depth;
  std::vector<double> velocity;
};

/// On [from, to], sampled densely and at both sides of every breakpoint.
ExactCurve exact_curve(const FlowProblem& problem, double from, double to, double t);
/// The same over the channel and whatever of the profile lies beyond it.
ExactCurve exact_curve(const FlowProblem& problem, const Profile& profile, double t);

/// The method's own curve: its reconstruction, sampled within every cell.
ExactCurve computed_curve(const Profile& profile);

/// Centres and mean values as arrays.
struct Means {
  std::vector<double> centre;
  std::vector<double> depth;
  std::vector<double> velocity;
};
Means means_of(const Profile& profile);

}  // namespace seiche::validation
