/// What becomes of a solitary wave that has climbed a slope and runs back, until the reflected wave has left or the run
/// fails.
#pragma once

#include <limits>
#include <string>

#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation {

struct RunDown {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double runup = none;         ///< first maximum; NaN where it was not passed
  double runup_time = none;    ///< of the highest shoreline, since the start
  bool fell = false;           ///< that maximum was passed
  double lowest = none;        ///< of the shoreline after it
  double later = none;         ///< highest of the shoreline from then on
  double energy = none;        ///< at the end, over that of the start
  std::string failure;         ///< empty if the run went through
  double failure_time = none;  ///< since the start
  double failure_place = none;
  bool sound = true;  ///< the state before the failure is finite, and the place of failure in its water

  [[nodiscard]] bool through() const { return failure.empty(); }
};

/// Follows a wave up and down the slope until the reflected wave is away; a Divergence becomes the result's failure.
RunDown run_down(const SolitaryClimb& climb);

}  // namespace seiche::validation
