#include "seiche/models/shallow_water_particles/hand_over.hpp"

#include <cmath>

namespace seiche::shallow_water_particles {

using shallow_water::jump_mass_flux;
using shallow_water::star_state;
using shallow_water::thrust;
using shallow_water::two_rarefaction_depth;

double InteriorJump::size() const {
  return std::abs(behind.depth - ahead.depth);
}

bool InteriorJump::inside() const {
  constexpr double guard = 1e-9;
  const auto holds = [](double fraction) { return fraction > guard && fraction < 1 - guard; };
  return holds(behind_by_volume) && holds(behind_by_momentum);
}

Structure structure_of(const InteriorJump& jump) {
  Structure s;
  s.particle = jump.particle;
  s.count = 2;
  const double behind = jump.behind_by_volume;
  if (jump.facing == Facing::right) {
    s.layers[0] = {jump.behind, behind};
    s.layers[1] = {jump.ahead, 1 - behind};
  } else {
    s.layers[0] = {jump.ahead, 1 - behind};
    s.layers[1] = {jump.behind, behind};
  }
  return s;
}

std::optional<InteriorJump> jump_between(double gravity, State left, State mean, State right, double threshold) {
  if (!(left.velocity > right.velocity)) return std::nullopt;
  // The Hugoniot curve lies above the curve of simple waves: the two-wave depth bounds the middle depth from above,
  // and most compressions are dismissed without an iteration.
  const double bound = two_rarefaction_depth(gravity, left, right);
  if (bound - right.depth <= threshold * right.depth && bound - left.depth <= threshold * left.depth) {
    return std::nullopt;
  }
  const State star = star_state(gravity, left, right);
  const double rise_right = star.depth - right.depth;
  const double rise_left = star.depth - left.depth;
  InteriorJump jump;
  jump.behind = star;
  if (rise_right > threshold * right.depth && rise_right > rise_left) {
    jump.facing = Facing::right;
    jump.ahead = right;
  } else if (rise_left > threshold * left.depth && rise_left > rise_right) {
    jump.facing = Facing::left;
    jump.ahead = left;
  } else {
    return std::nullopt;
  }
  const State a = jump.ahead;
  const State b = jump.behind;
  jump.behind_by_volume = (1 / a.depth - 1 / mean.depth) / (1 / a.depth - 1 / b.depth);
  jump.behind_by_momentum = (mean.velocity - a.velocity) / (b.velocity - a.velocity);
  if (!jump.inside()) return std::nullopt;
  jump.mass_flux = jump_mass_flux(gravity, a.depth, b.depth);
  return jump;
}

void hand_over(double gravity, const InteriorJump& jump, double mass, double tau, double& velocity,
               double& edge_thrust) {
  const double by_volume = (1 - jump.behind_by_volume) * mass / jump.mass_flux;
  const double by_momentum = (1 - jump.behind_by_momentum) * mass / jump.mass_flux;
  if (jump.leaves_through_wall) {
    // The wall keeps its velocity; behind the reflected jump the pressure is that of the reflected state.
    if (by_momentum < tau) {
      edge_thrust = (thrust(gravity, jump.ahead.depth) * by_momentum +
                     thrust(gravity, jump.reflected.depth) * (tau - by_momentum)) /
                    tau;
    }
    return;
  }
  if (by_volume < tau) velocity = (velocity * by_volume + jump.behind.velocity * (tau - by_volume)) / tau;
  if (by_momentum < tau) {
    edge_thrust = (edge_thrust * by_momentum + thrust(gravity, jump.behind.depth) * (tau - by_momentum)) / tau;
  }
}

}  // namespace seiche::shallow_water_particles
