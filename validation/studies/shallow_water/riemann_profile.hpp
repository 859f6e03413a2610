/// What is judged of a computed profile of depth and velocity beside the exact solution of a Riemann problem, and how
/// well a scheme of first order does: the same measures and limits for our own schemes and for others.
#pragma once

#include <string>
#include <vector>

#include "reports/evidence/criterion.hpp"
#include "seiche/exact/shallow_water/riemann.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"
#include "validation/studies/shallow_water/profile_points.hpp"

namespace seiche::validation {

/// The front that is judged: the right wave if it is a jump, else the left one if it is, else the dry front or the head
/// of the right fan.
struct JudgedFront {
  Front front;
  bool is_jump = false;
};
/// Whether there is a jump, or a dry side that the water has an end on.
bool has_front(const exact::Riemann& solution);
JudgedFront judged_front(const exact::Riemann& solution, double time);

/// Where a computed profile has its front: the jump, or the end of the water at a dry front. Cells have no end of the
/// water; the outermost one deeper than a thousandth of the deepest counts.
double judged_position(const exact::Riemann& solution, const JudgedFront& judged, const Profile& profile,
                       bool particles);

/// By how much a profile misses the exact one, between its first point and its last.
struct RiemannErrors : MeanErrors {
  double volume = 0;    ///< integral of h less the exact one [m^2]
  double momentum = 0;  ///< of h u [m^3/s]
  double front = 0;     ///< position of the jump, or of the end of the water, less the exact one [m]; NaN without one
  double celerity = 0;  ///< the depth is nearest to the exact one of the time (1 + celerity) t
};
RiemannErrors riemann_errors(const exact::Riemann& solution, double time, const ProfilePoints& points);

/// One thing that is required of it.
struct RiemannRequirement {
  std::string id, text, quantity, unit;
  double RiemannErrors::*error;
  evidence::Bound bound;
};

/// What is required of a solver with cells of this size, whatever points it prints.
/// @param start, end  of the channel [m]
/// @param apart       distance of the points, where that is more
/// @param viscosity   over that of Rusanov's flux, (|u| + c) dx/2
std::vector<RiemannRequirement> riemann_requirements(const exact::Riemann& solution, double time, double start,
                                                     double end, double cell, double apart = 0, double viscosity = 1);

}  // namespace seiche::validation
