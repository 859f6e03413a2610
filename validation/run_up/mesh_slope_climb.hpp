/// A solitary wave of the Euler equations climbs a plane slope on the two-dimensional Lagrangian mesh.
///
/// Units: depth and gravity are 1, y counts from still water. The tank begins at x = 0.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

struct MeshSlopeClimb {
  exact::SolitaryWave wave;
  double tan_slope = 1;
  double crest = 12;  ///< at the start
  double toe = 24;
  double spacing = 0.25;  ///< of columns
  long rows = 8;
  double tau = 0.025;
  mechanics::Scheme scheme = {};
  double hourglass = 0;
  double blend = 0;  ///< over which columns are sheared, before the toe; 0: max(4, 4 cot)
  /// Length of bottom and of slope that an arc at the toe replaces, over the columns' width; 0: the toe's node stays.
  double rounding = 0;
  /// Farthest that nodes may be from upright columns, in cells, before the mesh is rezoned; 0: never.
  double rezone = 0;
  /// Go on when cells tangle: their areas stay right, and the bottom's nodes may pass the toe.
  bool beyond_tangling = true;

  [[nodiscard]] lagrangian_mesh_2d::Flow start() const;
  /// "h1 = 0.25, 8 rows, tau = 0.025".
  [[nodiscard]] std::string resolution() const;
};

struct MeshSlopeRun {
  lagrangian_mesh_2d::Flow flow;  ///< at the end
  /// Largest elevation of the contact point, between steps from a parabola; NaN unless it fell after that.
  double runup = std::numeric_limits<double>::quiet_NaN();
  double time = 0;      ///< since the start
  Worst energy_defect;  ///< largest change over the wave's energy, until then
  struct Tangle {
    double time = 0;
    double place = 0;
  };
  std::optional<Tangle> tangle = {};  ///< the first
};

/// Runs until the contact point has fallen to 0.98 of its highest. Throws Divergence.
MeshSlopeRun climb_slope(const MeshSlopeClimb& climb,
                         const std::function<void(const lagrangian_mesh_2d::Flow&)>& after_step = {});

}  // namespace seiche::validation
