/// What the nodes of a lattice carry, between them: cubic in the numbers of the nodes.
///
/// A place has coordinates (i, j) on the lattice, whole at the nodes. Between them x, y and what the nodes carry are
/// the cubics through four nodes along each direction, next to sides those of the last four; places and values use the
/// same ones, so that a field which is linear in plan is reproduced on any lattice, and a smooth one to fourth order.
/// Where the cubics do not find a place, on a lattice about to fold, the bilinear cells do, to second order.
///
/// Values stay between the smallest and the largest of the nodes they come from: no new extremes.
///
/// When not to use it: to move water. It keeps no sums.
#pragma once

#include <array>
#include <span>

#include "seiche/geometry/curve.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

/// Coordinates on a lattice.
struct LatticePlace {
  double i = 0;
  double j = 0;
  bool cubic = true;  ///< false: of the bilinear cells
};

class LatticeInterpolant {
 public:
  /// @param x, y  places of the nodes; must outlive the object. At least three columns and rows.
  /// Throws std::invalid_argument.
  LatticeInterpolant(Shape shape, std::span<const double> x, std::span<const double> y);

  /// Where a place is on the lattice, sought from `guess` on. Beyond the sides by less than a cell.
  /// Throws mechanics::Infeasible if it is not found.
  [[nodiscard]] LatticePlace find(Point place, LatticePlace guess) const;
  /// Of values of the nodes.
  [[nodiscard]] double value(std::span<const double> values, const LatticePlace& at) const;
  /// The same, bilinear in the coordinates.
  [[nodiscard]] double linear_value(std::span<const double> values, LatticePlace at) const {
    at.cubic = false;
    return value(values, at);
  }
  /// The place itself.
  [[nodiscard]] Point point(const LatticePlace& at) const;

 private:
  struct Stencil;
  [[nodiscard]] Stencil stencil(const LatticePlace& at) const;
  [[nodiscard]] bool refine(Point place, LatticePlace& at) const;
  [[nodiscard]] LatticePlace find_cell(Point place, LatticePlace guess) const;

  Shape shape_;
  std::span<const double> x_, y_;
};

}  // namespace seiche::plan_lattice
