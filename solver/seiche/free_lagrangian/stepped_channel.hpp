/// A channel whose level bottom has a step up: rows of nodes before and above it.
#pragma once

#include "seiche/free_lagrangian/mesh.hpp"

namespace seiche::free_lagrangian {

struct SteppedChannel {
  double begin = 0;
  double step = 10;  ///< x of the step's face
  double end = 20;
  double bottom = -1;
  double shelf = -0.5;  ///< height of the bottom behind the step
  double level = 0;     ///< of the undisturbed surface
  int rows = 8;  ///< over the whole depth; there is a row at the shelf's height, above and below it even spacings
};

/// Cells about as wide as high. Every other row is shifted by half a column, counted from the surface, which is not; on
/// a shelf of an odd number of rows its own is, with a narrow cell at the corner. Walls: bottom, left end, face of the
/// step, shelf, right end. Throws std::invalid_argument.
Mesh stepped_channel_mesh(const SteppedChannel& channel);

}  // namespace seiche::free_lagrangian
