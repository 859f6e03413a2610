/// The outline of the water for plots, after markers have lost their order: the line of half the density.
///
/// The particles' masses are smoothed by Wendland's kernel of width 1.5 particle spacings on a grid of half a spacing,
/// and the line on which the sum is half the water's density is found cell by cell. It lies within a fraction of the
/// spacing of the surface; along walls it closes on itself.
///
/// When not to use it: measuring elevations, for which markers are better by orders.
#pragma once

#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"

namespace seiche::gauss_particles {

/// Closed lines with the water on their left-hand side; the first point is not repeated; the longest first. Markers
/// count for nothing.
/// @param density  of the water [kg/m^3]. @param spacing  of the particles [m]
/// Throws std::invalid_argument: arrays of different lengths, density or spacing not positive, a grid of more than 1e8
/// points.
std::vector<std::vector<Point>> surface_contours(std::span<const double> x, std::span<const double> y,
                                                 std::span<const double> mass, double density, double spacing);

}  // namespace seiche::gauss_particles
