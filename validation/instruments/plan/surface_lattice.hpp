/// The free surface at one time as nodes of a lattice that lies along a wall, whichever model it comes from.
#pragma once

#include <cstddef>
#include <span>

namespace seiche::validation {

/// Node (i, j) is number j (columns + 1) + i. Row j = 0 lies on the wall y = 0 and j counts away from it; i runs along
/// the wall with x increasing. Lengths in depths.
struct SurfaceLattice {
  std::size_t columns = 0;    ///< cells along the wall
  std::size_t rows = 0;       ///< cells away from it
  std::span<const double> x;  ///< of (columns + 1)(rows + 1) nodes
  std::span<const double> y;
  std::span<const double> z;  ///< elevation above still water

  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return j * (columns + 1) + i; }
};

}  // namespace seiche::validation
