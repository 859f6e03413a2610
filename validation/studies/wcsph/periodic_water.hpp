/// Water over a level bottom that repeats itself in x, started with exact velocities and pressures: weakly compressible
/// SPH with the kernel of Wendland, h = 2 dx, sound speed 10 sqrt(g depth), artificial viscosity 0.01.
#pragma once

#include <functional>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/scene.hpp"

namespace seiche::validation {

/// y counts from still water.
struct PeriodicWater {
  double period = 1;
  double depth = 1;
  double gravity = 1;
  double highest = 0.5;  ///< place above still water that the surface stays below
  std::function<double(double x)> elevation;
  std::function<Point(Point place)> velocity;   ///< up to the surface and as far above it as particles may stand
  std::function<double(Point place)> pressure;  ///< over the density, the same; extended below the bottom by its weight
};

/// @param spacing  of the particles; changed so that a whole number of them fills the period
wcsph::Flow start_sph(const PeriodicWater& water, double spacing);
/// Where the share of water is one half, for from <= x <= to. Throws Divergence where there is no surface.
std::vector<Point> surface_of(const wcsph::Flow& flow, const PeriodicWater& water, double from, double to);

}  // namespace seiche::validation
