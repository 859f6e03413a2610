/// A standing wave before a berm runs in time: forces step by step (berm_load.hpp).
#pragma once

#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/breakwater/berm_load.hpp"
#include "validation/breakwater/surface_modes.hpp"

namespace seiche::validation {

/// Forces over the height of the wave at the far wall, without those of still water.
struct BermHistory {
  std::vector<double> time, front, rear, total;
};

struct BermWave {
  lagrangian_mesh_2d::Flow flow;  ///< at the end
  BermHistory history;
};

struct BermRunSettings {
  double height = 0.01;  ///< at the far wall
  double time = 1;
  double tau = 0.02;
  double hourglass = 0;
};

/// From rest, in the shape of a mode of the same mesh. Throws Divergence.
BermWave run_berm_wave(const Berm& berm, std::size_t columns, std::size_t rows, const SurfaceMode& mode,
                       const BermRunSettings& settings);

}  // namespace seiche::validation
