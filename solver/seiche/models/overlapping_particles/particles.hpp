/// Sets of particles with fixed masses, in staggered rows.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "seiche/geometry/curve.hpp"

namespace seiche::overlapping_particles {

struct Particles {
  std::vector<double> x;     ///< [m]
  std::vector<double> y;     ///< [m]
  std::vector<double> mass;  ///< [kg/m]
  double spacing = 1;        ///< h, of neighbours [m]

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Throws std::invalid_argument naming the particle: arrays of different lengths, fewer than three particles, places
  /// not finite, masses or spacing not positive.
  void require_valid() const;
};

/// Rows of height h sqrt(3)/2, every other one shifted by h/2.
struct Rows {
  double spacing = 0.1;                    ///< h [m]
  Point lower, upper;                      ///< corners of the rectangle that is filled
  Point through;                           ///< a particle of an unshifted row
  double density = 1;                      ///< [kg/m^3]; a particle has that of h^2 sqrt(3)/2
  std::function<bool(Point)> inside = {};  ///< which places are taken; empty: all
};
/// Row by row from below. Throws std::invalid_argument, also where more than 1e7 places would be tried.
Particles staggered(const Rows& rows);

/// Disc about the origin, with a particle in its middle; on its rim too, but for the ends of the middle row. Together
/// they have the mass of the disc.
Particles staggered_disc(double radius, double spacing, double density = 1);

}  // namespace seiche::overlapping_particles
