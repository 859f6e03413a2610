/// A round drop that is stretched, by six models, for a contest: gravity is 0, density, radius and strain rate are 1.
#pragma once

#include <vector>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/geometry/curve.hpp"
#include "validation/studies/side_by_side/contest.hpp"

namespace seiche::validation {

/// Velocity of the drop's middle: without it there would be no momentum to be kept, and fixed lattices would not notice
/// that the drop moves.
constexpr Point drop_drift{0.3, 0.2};

/// The finest resolution of each model.
struct DropSizes {
  long mesh = 32;         ///< cells across
  long rings = 28;        ///< of free particles to the radius
  long overlapping = 20;  ///< spacings to the radius
  long cells = 16;        ///< rings of Dirichlet cells and of variable masses
  long sph = 40;          ///< spacings to the radius
};

/// Each on a few resolutions up to the finest. `drop` is kept by reference.
std::vector<Contender> drop_contenders(const exact::StretchingDrop& drop, const DropSizes& sizes);

}  // namespace seiche::validation
