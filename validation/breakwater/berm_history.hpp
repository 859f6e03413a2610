/// Forces of waves before a berm, step by step (berm_load.hpp), and a standing wave that runs in time.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "reports/evidence/figure.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/breakwater/berm_load.hpp"
#include "validation/breakwater/surface_modes.hpp"
#include "validation/instruments/mesh/mesh_gauges.hpp"

namespace seiche::validation {

/// Reads the forces off a flow after every step. Multipliers of single steps alternate; the mean of two steps' belongs
/// to the nodes' places between them.
class BermGauge {
 public:
  /// @param flow  must outlive the gauge; it has not yet been stepped
  BermGauge(const lagrangian_mesh_2d::Flow& flow, const Berm& berm);

  struct Reading {
    double time = 0;  ///< the end of the step before the last
    BermLoad load;    ///< without the forces of still water
  };
  /// To be called after every step; none after the first.
  std::optional<Reading> after_step();

 private:
  const lagrangian_mesh_2d::Flow* flow_;
  WallGauge wall_;
  double still_;  // on the rear wall
  std::vector<double> y_between_;
  double time_between_ = 0;
};

/// Forces over the height of the wave at the far wall, without those of still water.
struct BermHistory {
  std::vector<double> time, front, rear, total;
};

/// Front, rear and total.
void draw_forces(evidence::Panel& panel, const BermHistory& history);

struct BermWave {
  lagrangian_mesh_2d::Flow flow;  ///< at the end
  BermHistory history = {};
};

struct BermRunSettings {
  double height = 0.01;  ///< at the far wall
  double time = 1;
  double tau = 0.02;
  double rezone = 0;  ///< drift of a node at which the columns are set upright again, in cells; 0: never
};

/// Sees a flow before its first step and after each.
using FlowWatcher = std::function<void(const lagrangian_mesh_2d::Flow& flow)>;

/// From rest, in the shape of a mode of the same mesh. Throws Divergence.
BermWave run_berm_wave(
    const Berm& berm, const BermResolution& mesh, const SurfaceMode& mode, const BermRunSettings& settings,
    const FlowWatcher& watch = [](const lagrangian_mesh_2d::Flow&) {});

}  // namespace seiche::validation
