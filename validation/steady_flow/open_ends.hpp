/// Rounding of the mass of a particle flow between two open ends.
#pragma once

#include "reports/evidence/criterion.hpp"

namespace seiche::validation {

struct ChannelReach {
  double length = 0;     ///< [m]
  double depth = 0;      ///< largest [m]
  double discharge = 0;  ///< [m^2/s]
  double celerity = 0;   ///< largest [m/s]
};

/// What may be missing of all the water after `time`. The books are compensated sums; what rounds is the mass of the
/// two particles that fill and empty at the ends, at every step, and the sums once at last.
evidence::Roundoff open_ends_roundoff(const ChannelReach& reach, long particles, double time);

}  // namespace seiche::validation
