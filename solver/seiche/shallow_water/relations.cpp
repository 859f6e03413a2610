#include "seiche/shallow_water/relations.hpp"

#include <algorithm>
#include <limits>

namespace seiche::shallow_water {

State star_state(double gravity, State left, State right) {
  if (middle_dries(gravity, left, right)) return {0, 0};

  const double velocity_jump = right.velocity - left.velocity;
  double h = two_rarefaction_depth(gravity, left, right);
  // Newton on an increasing concave function, started left of or at the root's concave branch, converges in at most
  // six steps from any depth ratio; the cap only guards against a cycle in the last digit.
  constexpr int cap = 50;
  for (int k = 0; k < cap; ++k) {
    const double residual =
        velocity_change(gravity, h, left.depth) + velocity_change(gravity, h, right.depth) + velocity_jump;
    const double slope = velocity_change_slope(gravity, h, left.depth) + velocity_change_slope(gravity, h, right.depth);
    const double next = std::max(h - residual / slope, 0.1 * h);
    const bool settled = std::abs(next - h) <= std::numeric_limits<double>::epsilon() * h;
    h = next;
    if (settled) break;
  }
  const double u = 0.5 * (left.velocity + right.velocity) +
                   0.5 * (velocity_change(gravity, h, right.depth) - velocity_change(gravity, h, left.depth));
  return {h, u};
}

}  // namespace seiche::shallow_water
