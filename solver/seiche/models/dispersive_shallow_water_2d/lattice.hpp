/// Markers of the plan model: a lattice of water columns between the bottom and the free surface.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

using plan_lattice::Place;
using plan_lattice::Shape;
using plan_lattice::Sides;

/// Markers on the surface over a bottom.
struct Lattice {
  Shape shape;
  std::vector<double> x, y;  ///< places in plan [m]
  std::vector<double> z;     ///< elevations of the surface above still water [m]
  Sides sides = {};
  double depth = 1;  ///< of still water over a level bottom [m]
  /// Uneven bottom, which `depth` then does not describe; null for none.
  std::shared_ptr<const PlanBottom> bottom = {};

  /// Throws std::invalid_argument: fewer than one row or two columns, arrays of other lengths, values that are not
  /// finite, depth not positive, a cell with a corner that is not convex, a marker that is not above the bottom (by
  /// place); a shoreline without an uneven bottom, or a marker of it that is off the bottom by more than 1e-12.
  void require_valid() const;
};

/// In plan, of a cell whose corners are at q = (x, y, ...).
inline double cell_area(const Shape& shape, std::span<const double> q, std::size_t cell) {
  const std::size_t n = shape.nodes();
  const auto [c0, c1, c2, c3] = shape.corners(cell);
  return 0.5 * ((q[c2] - q[c0]) * (q[n + c3] - q[n + c1]) - (q[c3] - q[c1]) * (q[n + c2] - q[n + c0]));
}

/// A rectangle of equal cells, begin <= x <= end and south <= y <= north, under a given surface.
struct Rectangle {
  double begin = 0;
  double end = 0;
  double south = 0;
  double north = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::function<double(double x, double y)> elevation = {};  ///< of the surface; empty for still water
  Sides sides = {};
  double depth = 1;
  std::shared_ptr<const PlanBottom> bottom = {};
};
/// Throws std::invalid_argument for ends out of order.
Lattice rectangular_lattice(const Rectangle& rectangle);

}  // namespace seiche::dispersive_shallow_water_2d
