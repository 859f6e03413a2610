/// A column of water twice as high as wide collapses over a dry bed, by six models, for a contest. Its width, gravity
/// and density are 1.
#pragma once

#include <vector>

#include "validation/dam_break/column_front.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation {

constexpr double column_aspect = 2;
constexpr double column_tank = 8;  ///< length of the tank of SPH, in widths; the others have none

/// The finest resolution of each model, to the width.
struct ColumnSizes {
  long particles = 8;  ///< cells of the free particles
  long mesh = 8;       ///< columns of the Lagrangian mesh
  long cells = 8;      ///< columns of Dirichlet cells and of variable masses
  long overlapping = 12;
  long sph = 30;
};

/// What is off are fronts at the times of the measured points, with the one shift of the time origin that fits them
/// best.
std::vector<Contender> column_contenders(const ColumnFront& measured, const ColumnSizes& sizes);

}  // namespace seiche::validation
