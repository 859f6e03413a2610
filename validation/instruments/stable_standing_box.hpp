/// A standing wave's box whose time step the shortest waves of its cells bear.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "validation/instruments/dispersive_standing_mode.hpp"

namespace seiche::validation {

/// The box, if no wave between its markers is too fast for its step: omega tau <= 2, with omega^2 <= (g/H) max(1,
/// beta + 4 gamma (H/s)^2)/alpha whatever the wave. Beyond it the one-step scheme is unstable, and the sweeps of the
/// conservative one need not converge. Throws std::invalid_argument.
inline StandingBox stable(StandingBox box) {
  const double slope = 2 * box.depth / box.spacing();
  const double stiffness = std::max(1.0, box.slope_energy + box.gamma * slope * slope) / box.alpha;
  const double longest = 2 / std::sqrt(box.gravity / box.depth * stiffness);
  if (box.tau <= longest) return box;
  throw std::invalid_argument(
      fmt::format("tau = {:g} is out of range: must not exceed {:.4g} with alpha = {:g}, gamma = {:g} and markers "
                  "{:.3g} apart, or the shortest waves grow",
                  box.tau, longest, box.alpha, box.gamma, box.spacing()));
}

}  // namespace seiche::validation
