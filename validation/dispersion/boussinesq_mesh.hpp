/// Lagrangian meshes whose waves have nearly the law of Boussinesq's equations, omega^2 = k^2/(1 + k^2/3), depth and
/// gravity 1 (Frank 1994, section 2.1).
#pragma once

#include <cstddef>

namespace seiche::validation {

constexpr double shortest_like_boussinesq = 3.5;  ///< wavelength, in depths, down to which they are compared

/// Largest relative difference of the frequencies over these wavelengths.
double distance_from_boussinesq(double column_width, std::size_t rows);

/// Width of columns, between 0.001 and 1.7, with which it is smallest.
double boussinesq_width(std::size_t rows);

}  // namespace seiche::validation
