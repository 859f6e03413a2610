/// Laboratory basins in the plan model: regular waves that a paddle sends over an uneven bottom between walls, and a
/// layer that absorbs them before the far wall.
///
/// The improved dispersion of Madsen and Sorensen (1992), gamma = 1/15 and alpha = 1/3 + gamma. The paddle is the west
/// side, a piston that moves as a sine. Linear waves that it makes, far from it, are those of the model itself:
///
///     a = U k h/omega / (1 + gamma (k h)^4/nu),   nu = omega^2 h/g,   U its largest velocity,
///
/// for the markers, and for the water's surface more (instruments/plan/water_surface.hpp). The last factor
/// is what the wave that does not leave the paddle takes, x-dependence exp(-kappa x), (kappa h)^2 = nu/(gamma (k h)^2):
/// volume is kept at the paddle, and the slope of the surface there is zero. Lengths in metres, times in seconds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"

namespace seiche::validation::laboratory {

inline const std::string basin_model = "dispersive shallow water, 2DH, improved dispersion";

struct Basin {
  double begin = 0, end = 1;                         ///< place of the paddle at rest, of the far wall
  double south = 0, north = 1;                       ///< walls
  std::function<double(double x, double y)> bottom;  ///< z from the still-water level
  double raster = 0.1;       ///< spacing of the bottom's elevations, between which it is a bicubic spline
  double spacing = 0.1;      ///< of the columns at rest, or a little less
  double absorbed_from = 1;  ///< place where the layer begins
  double absorption = 3;     ///< its rate at the far wall, to which it grows as the square of the distance [1/s]
};

/// Regular waves of small amplitude at the paddle; the amplitude is that of the water's surface.
struct PaddleWaves {
  double depth = 1, amplitude = 0.01, period = 1;
};

/// U [m/s].
double paddle_velocity(const PaddleWaves& waves);

/// At rest; the paddle gathers speed over two periods.
dispersive_shallow_water_2d::Flow basin_flow(const Basin& basin, const PaddleWaves& waves);

/// Amplitudes of the first harmonics of the water's surface, [order - 1][place], from whole periods in steps of
/// period/steps: exact for a record that repeats itself.
std::vector<std::vector<double>> harmonics_at(dispersive_shallow_water_2d::Flow& flow, const std::vector<Point>& places,
                                              std::size_t orders, double period, long steps, long periods);

}  // namespace seiche::validation::laboratory
