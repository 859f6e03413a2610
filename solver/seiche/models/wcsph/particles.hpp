/// Particles of weakly compressible SPH: one array per quantity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace seiche::wcsph {

/// Fluid moves by the equations; walls stand; paddle k (kind = paddle, body = k) is carried by its motion.
enum class Kind : std::uint8_t { fluid, wall, paddle };

/// x horizontal, z up [m]; velocities [m/s]; density [kg/m^3]; mass per unit width [kg/m].
struct Particles {
  std::vector<double> x, z, u, w, density, mass;
  std::vector<Kind> kind;
  std::vector<std::int32_t> body;      ///< index of the paddle that carries the particle; -1 otherwise
  std::vector<std::int32_t> identity;  ///< number of the particle in the order of the beginning; sorting keeps it

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Appends one particle with the next identity.
  void add(double x_, double z_, double mass_, double density_, Kind kind_ = Kind::fluid, double u_ = 0, double w_ = 0,
           std::int32_t body_ = -1);
  [[nodiscard]] std::size_t count(Kind wanted) const;
};

// Walls that move: a piston or a flap hinged at the bottom, X_w = (S/2) sin(omega t) at the still-water level.
//
// The flap turns rigidly by theta = atan(X_w/d) about its hinge: sheared instead, its row of particles would stretch
// by sqrt(1 + (X_w/d)^2) and leak at large strokes.

/// Where a rigid body is: turned by angle about (hinge_x, hinge_z), then displaced along x.
struct Pose {
  double displacement = 0;  ///< [m]
  double angle = 0;         ///< [rad], positive: the top goes towards +x
};

/// A rigid body that carries particles. Particle positions of the beginning belong to the pose {0, 0}.
struct Paddle {
  double hinge_x = 0;
  double hinge_z = 0;
  std::function<Pose(double time)> pose;
  std::function<Pose(double time)> rate;  ///< its derivative with respect to time
};

struct PointMotion {
  double x, z, u, w;
};
/// Position and velocity at a time of the particle that is at (x, z) in the pose {0, 0}.
PointMotion carried(const Pose& pose, const Pose& rate, double hinge_x, double hinge_z, double x, double z);

/// @param stroke  S [m];  @param frequency  omega [1/s]
Paddle piston(double stroke, double frequency);
/// @param depth  d [m], from the hinge to the still-water level. Throws std::invalid_argument.
Paddle flap(double hinge_x, double hinge_z, double depth, double stroke, double frequency);

/// Arrays of one length, values finite, masses and densities positive, carriers that exist and can be asked. Throws
/// std::invalid_argument.
void check_particles(const Particles& particles, std::span<const Paddle> paddles);

// Places of particles at the beginning: regular lattices of fluid, staggered rows of walls.
//
// The plane is divided into cells dx x dx with a corner at (left, bottom). The square lattice has a particle in the
// middle of each cell, m = rho_0 dx^2; the body-centred one has two, at (1/4, 1/4) and (3/4, 3/4), m = rho_0 dx^2/2.
// In terms of vertical lines of particles, both have one particle per dx of height on every line; the lines stand dx
// or dx/2 apart.
//
// Walls are rows of particles dx apart; row k = 0, 1, 2 lies k dx/2 behind the line of the wall, odd rows shifted by
// dx/2 along it. The water begins dx/2 in front of that line.
//
// Reference: Dalrymple and Rogers, Numerical modeling of water waves with the SPH method, Coastal Eng. 53 (2006) 141.

enum class Lattice { square, body_centred };

/// "square" or "body_centred"; throws std::invalid_argument naming those that exist.
Lattice lattice_named(std::string_view name);

/// Area of the plane that belongs to one particle, as a part of dx^2.
double area_per_particle(Lattice lattice);

struct Place {
  double x, z;
};

/// Left <= right, bottom <= top [m].
struct Box {
  double left, right, bottom, top;
};
inline constexpr Box unbounded{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// A vertical line of particles of the undistorted lattice, one per dx of height.
struct LatticeLine {
  double x;
  double width;   ///< of the strip that belongs to it [m]
  double offset;  ///< of its particles above the bottom of their cell, in dx
};
/// Lines of the cells that fill [left, left + columns dx].
std::vector<LatticeLine> lattice_lines(Lattice lattice, double spacing, double left, long columns);

/// Points of the lattice in columns x rows cells from the corner (left, bottom).
std::vector<Place> rectangle(Lattice lattice, double spacing, double left, double bottom, long columns, long rows);

/// Points of the lattice of cells from the corner (box.left, box.bottom) that lie in the box and where `inside` holds.
std::vector<Place> shape(Lattice lattice, double spacing, const Box& box,
                         const std::function<bool(double x, double z)>& inside);

/// Staggered rows along a polyline, which has the fluid on its left and whose segments are whole numbers of dx long.
/// @param rows           2 is usual; 3 holds back what jets press through two
/// @param corners_twice  a particle for each of both segments at their common corner, as older generators have them
std::vector<Place> wall(std::span<const Place> corners, double spacing, int rows = 2, bool corners_twice = false);

}  // namespace seiche::wcsph
