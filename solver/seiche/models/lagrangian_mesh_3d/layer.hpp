/// Meshes of layers of water and of free bodies of fluid.
#pragma once

#include <functional>

#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Water over begin <= x <= end, south <= y <= north: equal cells in plan, vertical columns of layers of equal height.
struct Layer {
  double begin = 0;  ///< west side [m]
  double end = 1;    ///< east side [m]
  double south = 0;
  double north = 1;
  double depth = 1;  ///< of still water over a level bottom [m]
  std::size_t columns = 1;
  std::size_t rows = 1;
  std::size_t layers = 1;
  /// Surface elevation [m]; empty for still water.
  std::function<double(double x, double y)> elevation = {};
  Sides sides = {};
  /// Place of the south side, instead of `south`; rows then have equal widths on each line x = const. A wedge in a
  /// channel.
  std::function<double(double x)> south_wall = {};
  /// Uneven bottom, which `depth` then does not describe; null for none.
  std::shared_ptr<const PlanBottom> bottom = {};
};
/// Throws std::invalid_argument: ends out of order, no cells, depth not positive, a surface below the bottom (by
/// place). Throws OutsidePlanBottom.
Mesh layer_mesh(const Layer& layer);

/// A box of equal cells, [0, 1]^3 scaled to `sides` and moved to `corner`, that nothing holds.
struct Box {
  Vector corner, sides;
  Shape plan;
  std::size_t layers = 1;
};
Mesh free_box(const Box& box);

}  // namespace seiche::lagrangian_mesh_3d
