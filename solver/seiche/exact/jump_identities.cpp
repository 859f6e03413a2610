#include "seiche/exact/jump_identities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche::exact {

namespace sw = shallow_water;

SelfTest jump_identities(const std::string& name, double gravity, sw::State left, sw::State right, double speed,
                         double largest) {
  const auto mass = [&](sw::State s) { return s.depth * (s.velocity - speed); };
  const auto momentum = [&](sw::State s) { return mass(s) * (s.velocity - speed) + sw::thrust(gravity, s.depth); };
  // The fluxes are differences of velocities: their rounding is that of depth times the largest velocity.
  const double velocity = std::max({std::abs(left.velocity), std::abs(right.velocity), std::abs(speed), largest});
  const double depth = std::max(left.depth, right.depth);
  const double mass_scale = depth * velocity;
  const double momentum_scale = depth * velocity * velocity + sw::thrust(gravity, depth);
  const double limit = 32 * std::numeric_limits<double>::epsilon();
  const std::string reason = "about ten roundings on each side, and those of depth, velocity and speed themselves";
  return {{"mass is conserved across " + name, std::abs(mass(left) - mass(right)) / mass_scale, limit, reason},
          {"momentum is conserved across " + name, std::abs(momentum(left) - momentum(right)) / momentum_scale, limit,
           reason}};
}

}  // namespace seiche::exact
