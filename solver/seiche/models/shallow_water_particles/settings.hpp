/// Choices of the conservative particle method that do not change the equations, what happens at the two ends of a row
/// of particles, what acts on all of it, and its books.
#pragma once

#include <functional>
#include <optional>
#include <variant>

#include "seiche/compensated_sum.hpp"
#include "seiche/geometry/bottom_profile.hpp"

namespace seiche::shallow_water_particles {

/// How an edge between two particles gets its velocity and pressure.
enum class Level {
  godunov,  ///< G1: Riemann problem of the two particle means; first order, a jump is 3-4 particles wide
  muscl,    ///< M2: limited linear reconstruction and a half-step predictor; second order, a jump is 1-3 particles wide
  hand_over  ///< H2: M2 with the jump kept inside one particle and handed from one to the next; isolated jumps are
             ///< exact
};

/// Numerical parameters with the values recommended for all flows.
struct Scheme {
  Level level = Level::hand_over;
  double theta = 2;      ///< generalised minmod: 1 most dissipative, 2 monotonised central
  double courant = 0.4;  ///< largest tau c / w that largest_step() proposes, at most 0.9
};

/// Smallest relative depth jump that is handed over.
inline constexpr double jump_threshold = 0.02;

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

/// Impulses on the water per unit width and density [m^3/s], positive along +x, since the start of the run; inflows of
/// mass [m^2] count positive into the domain.
struct Ledger {
  double initial_mass = 0;
  double initial_momentum = 0;
  CompensatedSum left_impulse;
  CompensatedSum right_impulse;
  CompensatedSum bed_impulse;
  CompensatedSum friction_impulse;
  CompensatedSum source_impulse;
  CompensatedSum left_mass;
  CompensatedSum right_mass;

  [[nodiscard]] double booked_impulse() const {
    return left_impulse.value() + right_impulse.value() + bed_impulse.value() + friction_impulse.value() +
           source_impulse.value();
  }
  [[nodiscard]] double booked_mass() const { return left_mass.value() + right_mass.value(); }
};

}  // namespace seiche::shallow_water_particles
