/// Surfaces of solitary waves on Synolakis' beach 1 : 19.85, and how far two of them are from each other; what of his
/// exact solution for A = 0.019 is asked of others, who are judged by the same claims as our own model, some within
/// narrower limits.
///
/// Lengths in depths, times in sqrt(d/g) since the crest was arccosh(sqrt 20)/sqrt(3 A/4) before the toe; x from the
/// shoreline at rest, positive offshore.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"
#include "validation/case/parameter.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

inline constexpr double beach_cot_slope = 19.85;
inline constexpr double beach_theory_amplitude = 0.019;

struct Surface {
  std::vector<double> x, y;
};
using Profiles = std::map<double, Surface>;  ///< by time; gauges by place, with times for x

/// Of a table of reference_data. @param group, abscissa  its columns
Profiles profiles_of(const Values& values, const std::string& table, const std::string& group = "t",
                     const std::string& abscissa = "x_over_d");

struct Difference {
  Mean off;          ///< from the reference, over its points
  Mean size;         ///< of the reference
  double range = 0;  ///< of the reference
  long dry = 0;      ///< reference points where the model is dry
};

/// Where a surface has no water it is the beach: of a thin tongue two surfaces have different parts dry.
Difference difference(const Surface& model, const Surface& reference, double scale = 1);

/// One for every profile of the reference; without points where the model did not get so far.
using Differences = std::map<double, Difference>;
Differences differences(const Profiles& model, const Profiles& reference);

/// rms distance over rms elevation, all points of all profiles.
double relative_distance(const Differences& profiles);
/// Largest rms distance over the range of its profile, with the time.
Worst largest_over_range(const Differences& profiles);

struct BeachClaim {
  evidence::Claim claim;
  evidence::Bound bound;
};
/// All profiles together are the exact ones, by relative_distance(); and each of them, by largest_over_range().
BeachClaim all_profiles();
BeachClaim each_profile();

/// Profiles, gauges and run-up of the exact solution. Judging throws std::invalid_argument for fewer points than one in
/// a depth or a unit of time: there is more in the wave.
Submission beach_submission();

}  // namespace seiche::validation
