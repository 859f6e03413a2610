/// What the nodes of a lattice carry, between them: cubic in the numbers of the nodes.
///
/// A place has coordinates (i, j) on the lattice, whole at the nodes. Between them x, y and what the nodes carry are
/// the cubics through four nodes along each direction, next to sides those of the last four; places and values use the
/// same ones, so that a field which is linear in plan is reproduced on any lattice, and a smooth one to fourth order.
/// Where the cubics do not find a place, on a lattice about to tangle, the bilinear cells do, to second order.
///
/// Values stay between the smallest and the largest of the nodes they come from: no new extremes.
///
/// When not to use it: to move water. It keeps no sums.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "seiche/geometry/curve.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

/// Weights of a row's neighbouring nodes in the polynomial through them, and the weights' derivatives.
struct LatticeWeights {
  std::size_t first = 0;  ///< of the nodes
  std::size_t count = 0;
  std::array<double, 4> weight{}, slope{};
};

/// Through the four nodes around a place counted in cells, of a row with at least three; beyond its ends through the
/// outermost.
inline LatticeWeights cubic_weights(double at, std::size_t cells) {
  const double cell = std::clamp(std::floor(at), 0.0, static_cast<double>(cells) - 1);
  const double first = std::clamp(cell - 1, 0.0, static_cast<double>(cells) - 3);
  LatticeWeights w{.first = static_cast<std::size_t>(first), .count = 4};
  const double a = at - first;
  const double b = a - 1;
  const double c = a - 2;
  const double d = a - 3;
  w.weight = {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
  w.slope = {-(c * d + b * d + b * c) / 6, (c * d + a * d + a * c) / 2, -(b * d + a * d + a * b) / 2,
             (b * c + a * c + a * b) / 6};
  return w;
}

/// Through the two nodes of a cell.
inline LatticeWeights linear_weights(double at, std::size_t cells) {
  const double first = std::clamp(std::floor(at), 0.0, static_cast<double>(cells) - 1);
  LatticeWeights w{.first = static_cast<std::size_t>(first), .count = 2};
  w.weight = {1 - (at - first), at - first};
  w.slope = {-1, 1};
  return w;
}

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

 private:
  struct Stencil;
  [[nodiscard]] Stencil stencil(const LatticePlace& at) const;
  [[nodiscard]] bool refine(Point place, LatticePlace& at) const;

  Shape shape_;
  std::span<const double> x_, y_;
};

}  // namespace seiche::plan_lattice
