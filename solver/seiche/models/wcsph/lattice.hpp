/// Places of particles at the beginning: regular lattices of fluid, staggered rows of walls.
///
/// The plane is divided into cells dx x dx with a corner at (left, bottom). The square lattice has a particle in the
/// middle of each cell, m = rho_0 dx^2; the body-centred one has two, at (1/4, 1/4) and (3/4, 3/4), m = rho_0 dx^2/2.
/// In terms of vertical lines of particles, both have one particle per dx of height on every line; the lines stand dx
/// or dx/2 apart.
///
/// Walls are rows of particles dx apart; row k = 0, 1, 2 lies k dx/2 behind the line of the wall, odd rows shifted by
/// dx/2 along it. The water begins dx/2 in front of that line.
///
/// Reference: Dalrymple and Rogers, Numerical modeling of water waves with the SPH method, Coastal Eng. 53 (2006) 141.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace seiche::wcsph {

enum class Lattice { square, body_centred };

/// "square" or "body_centred"; throws std::invalid_argument naming those that exist.
Lattice lattice_named(std::string_view name);
std::string_view name_of(Lattice lattice);

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
