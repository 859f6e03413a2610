/// A part of a surface, for figures.
#pragma once

#include <vector>

#include "reports/evidence/figure.hpp"
#include "validation/instruments/plan/surface_lattice.hpp"

namespace seiche::validation {

struct SurfacePart {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> x = {}, y = {}, z = {};

  [[nodiscard]] evidence::Lattice lattice() const { return {columns, rows, x, y, z}; }
};

/// What to keep: of x from `from` to `to`, of y up to `top`.
struct Extent {
  double from, to, top;
};

/// The columns and rows whose nodes on the wall and on the west side lie in the extent; x then counts from `origin`.
/// Throws std::invalid_argument if that is less than one cell.
SurfacePart part_of(const SurfaceLattice& surface, const Extent& extent, double origin = 0);

}  // namespace seiche::validation
