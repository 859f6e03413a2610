/// A wave between vertical walls, by the models of a layer of water, for a contest. Depth, gravity and density are 1;
/// the bottom is level, or has a shape that some of the models can follow.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/studies/side_by_side/contest.hpp"
#include "validation/studies/wcsph/periodic_water.hpp"

namespace seiche::validation {

struct TankWave {
  double length = 1;     ///< between the walls, at x = 0 and there
  PeriodicWater water;   ///< the first instant, and its continuation beyond the walls, which SPH has in their place
  double speed = 1;      ///< of the wave, for the steps
  double amplitude = 1;  ///< over which the surface is off
  std::function<double(double x, double time)> surface;  ///< where it should be
  /// The part of the tank that counts at a time.
  struct Part {
    double from, to;
  };
  std::function<Part(double time)> part;
  /// Of an uneven bottom, by x.
  struct Bottom {
    std::function<double(double)> elevation, slope, curvature;
  };
  std::optional<Bottom> bottom = {};

  /// Of points of the surface, in height over the amplitude.
  [[nodiscard]] std::vector<double> off(const std::vector<Point>& points, double time) const;
};

/// An exact solitary wave whose crest is at x = start, on its way to the right.
/// @param period  of the water that SPH has: the length, or twice that where walls matter, the rest its mirror image
TankWave solitary_tank(const exact::SolitaryWave& wave, double start, double length, double period);

/// Finest resolutions: rows of cells or particles to the depth, cells of the free particles to the depth, markers of
/// the dispersive model to the depth. 0: without the model.
struct TankSizes {
  long particles = 4;
  long mesh = 16;
  long cells = 12;  ///< of Dirichlet cells and of variable masses
  long sph = 16;
  long markers = 16;
};

/// By the parameters of these names; 0 where there is none.
TankSizes tank_sizes(const Values& values);

/// Of the dispersive model: its channel and markers that are so far apart at rest.
using DispersiveStart = std::function<dispersive_shallow_water_1d::Flow(double spacing)>;

/// Each on a few resolutions up to the finest; all but the dispersive model, whose first instant is its own, from the
/// wave's. Cells and SPH have no uneven bottom. `wave` is kept by reference.
std::vector<Contender> tank_contenders(const TankWave& wave, const DispersiveStart& dispersive, const TankSizes& sizes);

}  // namespace seiche::validation
