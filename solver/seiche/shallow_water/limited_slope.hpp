#pragma once

#include <algorithm>
#include <cmath>

namespace seiche::shallow_water {

/// Generalised minmod of the two one-sided slopes and `theta` times them: theta = 1 is minmod, theta = 2 the
/// monotonised central limiter. Zero at an extremum.
///
/// @param backward, forward  one-sided slopes
/// @param central            the slope taken where the function is smooth
inline double limited_slope(double backward, double central, double forward, double theta) {
  if (backward * forward <= 0) return 0;
  const double magnitude = std::min({theta * std::abs(backward), std::abs(central), theta * std::abs(forward)});
  return std::copysign(magnitude, backward);
}

}  // namespace seiche::shallow_water
