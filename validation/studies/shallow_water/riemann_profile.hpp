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
JudgedFront judged_front(const exact::Riemann& solution, double time);

/// Where a computed profile has its front: the jump, or the end of the water at a dry front. Cells have no end of the
/// water; the outermost one deeper than a thousandth of the deepest counts.
double judged_position(const exact::Riemann& solution, const JudgedFront& judged, const Profile& profile,
                       bool particles);

/// By how much a profile misses the exact one, between its first point and its last.
struct RiemannErrors : MeanErrors {
  double volume = 0;    ///< integral of h less the exact one [m^2]
  double momentum = 0;  ///< of h u [m^3/s]
  double front = 0;     ///< position of the jump less the exact one [m]; NaN where there is none
};
RiemannErrors riemann_errors(const exact::Riemann& solution, double time, const ProfilePoints& points);

/// One thing that is required of it.
struct RiemannRequirement {
  std::string id, text, quantity, unit;
  double RiemannErrors::*error;
  evidence::Bound bound;
};

/// How a scheme of first order smears the waves.
struct Smearing {
  double cells_wide = 8;  ///< cells over which a jump is spread
  double viscosity = 1;   ///< over that of Rusanov's flux, (|u| + c) dx/2
};

/// What is required of a solver with cells of this size, whatever points it prints.
/// @param length  of the channel [m]
std::vector<RiemannRequirement> riemann_requirements(const exact::Riemann& solution, double time, double length,
                                                     double cell, const Smearing& smearing = {});

}  // namespace seiche::validation
