#include "seiche/exact/bore_reflection.hpp"

#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/jump_identities.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

namespace sw = shallow_water;

BoreReflection::BoreReflection(const Bore& incident, double wall) : incident_(incident), wall_(wall) {
  require_finite("wall", wall);
  if (incident.ahead().velocity != 0) {
    throw std::invalid_argument(fmt::format("velocity ahead of the bore = {:.17g} is out of range: must be 0 at a wall",
                                            incident.ahead().velocity));
  }
  if (!(wall > incident.position(0))) {
    throw std::invalid_argument(fmt::format("wall = {:.17g} is out of range: must lie beyond the bore's start = {:g}",
                                            wall, incident.position(0)));
  }
  const sw::State behind = incident.behind();
  time_ = (wall - incident.position(0)) / incident.speed();
  depth_ = sw::star_state(incident.gravity(), behind, {behind.depth, -behind.velocity}).depth;
  // a- = -u1 h1/(h2 - h1) without the difference of depths: u1 minus the mass swept by the jump over h1.
  speed_ = behind.velocity - sw::jump_mass_flux(incident.gravity(), behind.depth, depth_) / behind.depth;
}

BoreReflection BoreReflection::from_depths(double gravity, double ahead, double behind, double start, double wall) {
  return {Bore(gravity, ahead, behind, 0, start), wall};
}

BoreReflection BoreReflection::from_velocity(double gravity, double behind, double behind_velocity, double start,
                                             double wall) {
  return {Bore::from_velocity(gravity, behind, behind_velocity, start), wall};
}

double BoreReflection::position(double t) const {
  require_not_negative("t", t);
  return t < time_ ? incident_.position(t) : wall_ + speed_ * (t - time_);
}

sw::State BoreReflection::at(double x, double t) const {
  require_finite("x", x);
  if (x > wall_) throw std::invalid_argument(fmt::format("x = {:.17g} is out of range: the wall is at {:g}", x, wall_));
  if (x < position(t)) return incident_.behind();
  return t < time_ ? incident_.ahead() : sw::State{depth_, 0};
}

double BoreReflection::uncertainty() const {
  return 20 * std::numeric_limits<double>::epsilon();
}

SelfTest BoreReflection::self_test() const {
  SelfTest tests = jump_identities("the incident bore", incident_.gravity(), incident_.behind(), incident_.ahead(),
                                   incident_.speed());
  const SelfTest reflected =
      jump_identities("the reflected bore", incident_.gravity(), incident_.behind(), {depth_, 0}, speed_);
  tests.insert(tests.end(), reflected.begin(), reflected.end());
  return tests;
}

Provenance BoreReflection::provenance() {
  return {
      "Stoker, Water Waves (1957), section 10.7; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by "
      "the particle method, section 5",
      "u1 = (h2 - h1) sqrt(g (h2 + h1)/(2 h1 h2)), a- = -u1 h1/(h2 - h1)"};
}

static_assert(ReferenceSolution<BoreReflection>);

}  // namespace seiche::exact
