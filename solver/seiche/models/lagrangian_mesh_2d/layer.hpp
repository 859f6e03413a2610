/// Meshes of layers of water and of free patches.
#pragma once

#include <functional>
#include <memory>

#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

/// Rectangle [left, right] x [bottom, top] of equal cells, free on all sides.
Mesh free_patch(std::size_t columns, std::size_t rows, Point lower_left, Point upper_right);

/// Water between vertical walls, on a level bottom or a curved one, along which the nodes slide.
struct Layer {
  double begin = 0;  ///< left wall [m]
  double end = 1;    ///< right wall [m]
  double depth = 1;  ///< of still water [m]
  std::size_t columns = 1;
  std::size_t rows = 1;
  /// Surface elevation [m]; empty for still water. Columns then hold equal areas, over a curved bottom equal widths.
  std::function<double(double x)> elevation = {};
  /// Curved bottom, which `depth` then does not describe; null for none.
  std::shared_ptr<const GraphCurve> bottom = {};
};
/// Throws std::invalid_argument: end <= begin, no cells, depth not positive, a surface below the bottom.
Mesh layer_mesh(const Layer& layer);

/// The same with the right wall inclined outwards through the toe (end, -depth), its tangent `tan_slope`: columns are
/// sheared over the last `blend` before the toe, from nothing to the wall's slope.
/// @param blend  [m]; 0: the larger of 4 and 4 cot depths
/// @param rounding  length of bottom and of slope that an arc at the toe replaces [m]: the toe's node slides then, and
///                  the bottom's nodes follow it up the slope; 0: a corner, whose node stays
Mesh layer_mesh_with_slope(const Layer& layer, double tan_slope, double blend = 0, double rounding = 0);

}  // namespace seiche::lagrangian_mesh_2d
