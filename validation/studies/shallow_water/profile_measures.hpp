/// How far a computed shallow-water profile is from the exact one, and what its jump looks like.
#pragma once

#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"
#include "validation/studies/shallow_water/flow.hpp"

namespace seiche::validation {

/// Depth and velocity along x.
struct ProfileCurve {
  std::vector<double> x, depth, velocity;

  void add(double place, State state);
};

/// On [from, to], sampled densely and at both sides of every breakpoint.
ProfileCurve exact_curve(const FlowProblem& problem, double from, double to, double t);
/// The same over the channel and whatever of the profile lies beyond it.
ProfileCurve exact_curve(const FlowProblem& problem, const Profile& profile, double t);

/// The method's own curve: its reconstruction, sampled within every cell.
ProfileCurve computed_curve(const Profile& profile);

/// Of a cell.
double centre_of(const Profile& profile, std::size_t cell);
/// Mean values at the centres of the cells.
ProfileCurve means_of(const Profile& profile);

/// The three measures of a profile's distance from the exact one; which is which: error_measures.hpp. NaN where there
/// is no profile.
struct ProfileErrors {
  shallow_water::ProfileError cell;
  shallow_water::ProfileError reconstructed;
  shallow_water::ProfileError constant;

  /// Of a profile that is not there.
  static ProfileErrors none();
};

/// Errors at time t. Means are taken over the length of the profile.
ProfileErrors profile_errors(const Profile& profile, const FlowProblem& problem, double t);

/// How far mean depths are above `highest` or below `lowest`, with the position; 0 if none is.
Worst excursion(const Profile& profile, double lowest, double highest);

/// A jump whose position and width are judged.
struct Front {
  double behind = 0;    ///< depth behind it, to its left [m]
  double ahead = 0;     ///< depth ahead of it [m]
  double position = 0;  ///< exact [m]
  double reach = 0;     ///< the profile is searched this far on either side [m]
};
/// Number of cells between 5 % and 95 % of the jump; NaN for a profile that does not cross its mid-depth.
double front_width(const Profile& profile, const Front& front);
/// Where the profile crosses the mid-depth of the jump: at the jump inside a cell if the method keeps one there, else
/// where the means cross it, by linear interpolation between centres; NaN if they do not.
double front_position(const Profile& profile, const Front& front);

}  // namespace seiche::validation
