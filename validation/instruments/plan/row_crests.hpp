/// The crests that the rows of a surface lattice cross, between the nodes.
///
/// A crest is a node higher than its neighbours in the row; its place and height are those of the top of the parabola
/// through the three. Where the row is not straight (nodes displaced across it) the parabola runs over x - lean y, the
/// distance from a crest x = lean y + const: over x alone a displacement d of a node would shift it by lean d.
/// Heights are low or high by terms of fourth order in the spacing over the crest's width.
#pragma once

#include <vector>

#include "validation/instruments/plan/surface_lattice.hpp"

namespace seiche::validation {

struct Crest {
  double x = 0;
  double y = 0;
  double height = 0;
  std::size_t column = 0;  ///< the highest node
};

/// Throws std::invalid_argument unless the spans fit the lattice, it has 4 by 4 cells and all numbers are finite.
void require_complete(const SurfaceLattice& surface);

/// Crests of row j higher than `threshold`, from the front (largest x) backwards.
std::vector<Crest> row_crests(const SurfaceLattice& surface, std::size_t j, double threshold);

/// The crest whose highest node is (column, j), 0 < column < columns. Throws std::invalid_argument if the x - lean y of
/// its neighbours do not increase.
Crest refined_crest(const SurfaceLattice& surface, std::size_t column, std::size_t j, double lean);

/// Highest value of the polynomial through the five nodes about a crest's highest node: right to sixth order in the
/// spacing. Its difference from the crest's height is what the parabola misses.
double five_node_height(const SurfaceLattice& surface, const Crest& crest, std::size_t j);

/// The foremost crest on the wall that is higher than `threshold`: farther back may be others, of waves that return
/// from a lattice's far side or hit its rear. Throws std::runtime_error if there is none.
Crest wall_crest(const SurfaceLattice& surface, double threshold);

}  // namespace seiche::validation
