/// Gauges that stand at fixed places in a flow whose lattice moves: the surface between the four markers around each.
///
/// The place within a cell is found by Newton's method for the bilinear map of its corners; a gauge looks for its cell
/// beginning with the one it stood in before, from neighbour to neighbour.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::validation {

/// Coordinates of all nodes of a lattice.
struct PlanSurface {
  std::span<const double> x, y, z;
};

class PlanGauges {
 public:
  PlanGauges(plan_lattice::Shape shape, std::vector<Point> places);

  /// Elevations at the gauges, by the bilinear surface; NaN where the lattice does not reach.
  std::span<const double> read(PlanSurface surface);

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t nearest_cell(Point place, PlanSurface surface) const;
  double read_one(std::size_t gauge, PlanSurface surface);

  plan_lattice::Shape shape_;
  std::vector<Point> places_;
  std::vector<std::size_t> cells_;  ///< where they stood; none before the first reading
  std::vector<double> elevations_;
};

}  // namespace seiche::validation
