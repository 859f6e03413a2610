/// A cell of a lattice as the bilinear map of its corners: from coordinates (s, t), both in [0, 1] inside, to what the
/// corners carry, and back from a place in plan.
#pragma once

#include <cstddef>
#include <span>

#include "seiche/geometry/curve.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

struct CellCoordinates {
  double s = 0.5, t = 0.5;
};

/// What the corners of a cell carry, anticlockwise; s grows from the first to the second, t from the first to the last.
struct CornerValues {
  double c0, c1, c2, c3;

  [[nodiscard]] double at(CellCoordinates a) const {
    return (1 - a.t) * ((1 - a.s) * c0 + a.s * c1) + a.t * ((1 - a.s) * c3 + a.s * c2);
  }
  [[nodiscard]] double along_s(double t) const { return (1 - t) * (c1 - c0) + t * (c2 - c3); }
  [[nodiscard]] double along_t(double s) const { return (1 - s) * (c3 - c0) + s * (c2 - c1); }
};

/// Of what all nodes carry.
CornerValues corner_values(std::span<const double> values, const Shape& shape, std::size_t cell);

/// Where a place is in a cell with corners (x, y), by Newton's method. Outside the map may fold: there the coordinates
/// tell the way, and stay within two cells.
CellCoordinates find_in_cell(Point place, const CornerValues& x, const CornerValues& y);

}  // namespace seiche::plan_lattice
