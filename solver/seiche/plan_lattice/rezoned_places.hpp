/// Where the nodes of a Lagrangian lattice are put when it is rezoned: along its rows, on given lines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

/// A row of nodes as a curve: the cubic through four of them, no farther from their polyline than a twentieth of its
/// edge. The nodes must outlive it; at least four.
class RowCurve {
 public:
  RowCurve(std::span<const double> x, std::span<const double> y) : x_(x), y_(y) {}

  /// At a place counted in nodes.
  [[nodiscard]] Point at(double number) const;
  /// Where it meets the line through two points, sought from a node on by at most two edges; where it does not, the
  /// place of the line beside the node.
  [[nodiscard]] Point meet(std::size_t node, Point from, Point to) const;

 private:
  std::span<const double> x_, y_;
};

struct RezonedPlaces {
  std::vector<double> x, y;

  [[nodiscard]] Point operator[](std::size_t node) const { return {x[node], y[node]}; }
  void put(std::size_t node, Point place) {
    x[node] = place.x;
    y[node] = place.y;
  }
};

/// Farthest of a node at (x, y) from its new place, over the shortest edge at the new place.
double farthest(const Shape& shape, std::span<const double> x, std::span<const double> y, const RezonedPlaces& places);

}  // namespace seiche::plan_lattice
