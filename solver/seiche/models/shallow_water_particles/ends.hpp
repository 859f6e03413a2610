/// What happens at the two ends of a row of particles, and what acts on all of it.
#pragma once

#include <functional>
#include <optional>
#include <variant>

#include "seiche/geometry/bottom_profile.hpp"

namespace seiche::shallow_water_particles {

/// Fixed wall.
struct Wall {};

/// Wall moving with velocity(t) [m/s]. A piston at the inflow velocity is the way to let a uniform stream enter: the
/// whole domain translates, and nothing needs to be injected before a disturbance arrives at it.
struct Piston {
  std::function<double(double)> velocity;
};

/// The uniform state of the end particle continues outside.
struct Free {};

/// Dry bed outside: a front on a flat bed, a shoreline on an uneven one.
struct Vacuum {};

/// Fixed section that water passes, in either direction. The end particle keeps one edge there, grows or shrinks by the
/// mass that passes, and is split or merged with its neighbour when its width leaves (1/2, 2) of the initial one.
///
/// Give the discharge for a subcritical inlet, the depth for a subcritical outlet, both for a supercritical inlet and
/// neither for a supercritical outlet; what is not given follows from the characteristic that leaves the flow.
struct Open {
  std::function<double(double)> discharge;  ///< h u(t) [m^2/s], positive along +x
  std::function<double(double)> depth;      ///< h(t) [m]
};

using End = std::variant<Wall, Piston, Free, Vacuum, Open>;

struct Ends {
  End left = Wall{};
  End right = Wall{};
};

/// What acts on the water: gravity [m/s^2], an uneven bed, Manning friction n [s/m^(1/3)], a body force f(x,t) [m/s^2].
struct Forcing {
  double gravity = 9.81;
  std::optional<Bed> bed;
  double manning = 0;
  std::function<double(double, double)> body_force;
};

}  // namespace seiche::shallow_water_particles
