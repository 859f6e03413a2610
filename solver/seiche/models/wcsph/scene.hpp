/// Particles of the usual problems, ready for Flow: dam break, tank, flume with a paddle, periodic layer, free patch.
///
///     const Scene scene = dam_break({.width = a, .height = 2 * a, .tank_length = 4 * a, .wall_height = 3.5 * a,
///                                    .spacing = a / 50}, settings);
///     settings.period = scene.period;
///     Flow flow(scene.particles, scene.spacing, settings, scene.paddles);
///
/// Origin: where the water effectively begins, half a spacing in front of the rows of wall particles. In all scenes the
/// effective rear wall (or the paddle at rest) is x = 0 and the effective bottom z = 0, so that the first particles of
/// the square lattice are at dx/2.
///
/// Densities of the beginning are hydrostatic, rho = rho_0 (1 + rho_0 g (z_s - z)/B)^(1/gamma), for the fluid and for
/// walls beside it; masses are rho_0 times the area of the lattice. From the settings gravity, the equation of state
/// and what concerns walls are used.
///
/// Walls whose pressure is extrapolated (Settings::walls) continue the lattice of the water as far as the kernel
/// reaches, wall_rows then counts for paddles and flumes only.
///
/// Lengths that are not whole numbers of dx within 1e-9 are rounded to the nearest; Scene::warnings says so. All throw
/// std::invalid_argument naming parameter, value and range.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"

namespace seiche::wcsph {

struct Velocity {
  double u, w;  ///< [m/s]
};

struct Scene {
  Particles particles;
  double spacing = 0;           ///< dx [m]
  std::vector<Paddle> paddles;  ///< at most one
  Period period;
  double rear_wall = 0;    ///< effective, x [m]; lengths along the tank count from here
  double far_wall = 0;     ///< effective, x [m]; the period in periodic scenes
  double bottom = 0;       ///< effective, z [m]
  double still_water = 0;  ///< level of the water of the beginning, of the column or of the mean surface, z [m]
  /// Of the walls, infinite where there is none: a fluid particle outside has left the domain.
  Box extents = unbounded;
  std::vector<std::string> warnings;
};

/// Column of water at the rear wall of an open tank, before a dry floor or lower water at rest. Both are in hydrostatic
/// balance by themselves: the gate between them is gone at once.
struct DamBreak {
  double width = 0;        ///< of the column [m]
  double height = 0;       ///< of the column [m]
  double water_ahead = 0;  ///< depth of the water from the column to the far wall, at most `height` [m]; 0: a dry floor
  double tank_length = 0;  ///< between the front rows of both walls [m]
  double wall_height = 0;  ///< from the front row of the bottom [m]
  double spacing = 0;      ///< dx [m]
  Lattice lattice = Lattice::square;
  int wall_rows = 2;
  bool corners_twice = false;
};
Scene dam_break(const DamBreak& dam, const Settings& settings);

/// Water at rest between two walls.
struct Tank {
  double width = 0;        ///< of the water [m]
  double depth = 0;        ///< of the water [m]
  double wall_height = 0;  ///< above the effective bottom [m]; 0: depth and four spacings
  double spacing = 0;
  Lattice lattice = Lattice::square;
  int wall_rows = 2;
};
Scene tank(const Tank& parameters, const Settings& settings);

enum class Wavemaking { piston, flap };

/// Water at rest between a paddle at x = 0 and a wall at the far end.
struct Flume {
  double length = 0;         ///< of the water [m]
  double depth = 0;          ///< of the water, d [m]
  double wall_height = 0;    ///< of the far wall above the effective bottom [m]; 0: 2 depth
  double paddle_height = 0;  ///< the same of the paddle; 0: wall_height
  Wavemaking wavemaking = Wavemaking::flap;
  double stroke = 0;     ///< S at the still-water level [m]; X_w = (S/2) sin(omega t)
  double frequency = 0;  ///< omega [1/s]
  double spacing = 0;
  Lattice lattice = Lattice::square;
  int wall_rows = 2;
  int paddle_rows = 3;
};
Scene flume(const Flume& parameters, const Settings& settings);

/// Water between a level bottom and z = elevation(x), in a box that repeats itself in x. Columns have the number of
/// particles that keeps their spacing nearest to dx, and the mass that keeps the volume.
struct PeriodicLayer {
  double period = 0;                                     ///< L [m]
  double depth = 0;                                      ///< of the mean surface [m]
  std::function<double(double x)> elevation;             ///< above z = depth [m]; empty: level
  std::function<Velocity(double x, double z)> velocity;  ///< empty: at rest
  std::function<double(double x, double z)> pressure;    ///< [Pa]; empty: hydrostatic below the surface above it
  double spacing = 0;
  Lattice lattice = Lattice::square;
  int wall_rows = 2;
};
Scene periodic_layer(const PeriodicLayer& layer, const Settings& settings);

/// Free patch of fluid without walls: a circle about the origin, or where `inside` holds within `box`.
struct Patch {
  double radius = 0;                                     ///< of the circle [m]
  std::function<bool(double x, double z)> inside;        ///< empty: the circle
  Box box{};                                             ///< around `inside`
  std::function<Velocity(double x, double z)> velocity;  ///< empty: at rest
  std::function<double(double x, double z)> pressure;    ///< [Pa]; empty: 0
  double spacing = 0;
  Lattice lattice = Lattice::square;
};
Scene patch(const Patch& parameters, const Settings& settings);

}  // namespace seiche::wcsph
