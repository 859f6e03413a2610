/// The volume between the level z = 0 and an uneven bottom, cell by cell, as a sum over directed edges p -> q:
///
///     int b dA = sum of E_pq,   E_pq = (y_q - y_p) int_0^1 B(x(t), y(t)) dt,   B_x = b
///
/// by Gauss's rule of three points, exact for bottoms of degree 4. Edges cancel between neighbours, so that inner nodes
/// of raised water at rest feel no force, whatever the error of the rule.
///
/// Discrete gradients over a way: what Simpson's mean lacks of E's difference is divided by the way. B counts from far
/// away, and the difference of two E has the round-off of |B|, which a short way would make a force: a step's sweeps
/// then never settle. So only differences of B over the way enter, which are as short as it is.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/element.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

/// Gauss's rule of three points on [0, 1].
struct GaussPoint {
  double t;
  double weight;
};

inline const std::array<GaussPoint, 3>& gauss_points() {
  static const double half = 0.5 * std::sqrt(0.6);
  static const std::array points{GaussPoint{0.5 - half, 5.0 / 18}, GaussPoint{0.5, 8.0 / 18},
                                 GaussPoint{0.5 + half, 5.0 / 18}};
  return points;
}

class BottomVolume {
 public:
  struct Places {
    const double* x;
    const double* y;
  };

  BottomVolume(plan_lattice::Shape shape, std::shared_ptr<const PlanBottom> bottom);

  /// Subtracts the gradients of the volumes from those of the cells, in rows: at q0 if q1 is the same, else discrete
  /// gradients over the segment: Simpson's mean, corrected along the segment so that gradient times segment is the
  /// difference of the volumes to round-off.
  void subtract_gradients(Places q0, Places q1, linear::RowBlocks& gradients);
  /// int b dA over a cell.
  [[nodiscard]] double volume(Places at, std::size_t cell) const;

 private:
  /// E and its derivatives with respect to x_p, y_p, x_q, y_q.
  struct Edge {
    double value = 0;
    double xp = 0, yp = 0, xq = 0, yq = 0;
  };
  /// E, its derivatives but for what B itself gives, and the integral of B over the edge's parameter: of E's
  /// derivatives -B belongs to y_p and B to y_q.
  struct Parts {
    double value = 0;
    double xp = 0, yp = 0, xq = 0, yq = 0;
    double integral = 0;
  };

  [[nodiscard]] Parts parts(Places at, std::size_t p, std::size_t q) const;
  [[nodiscard]] Edge edge(Places at, std::size_t p, std::size_t q) const;
  [[nodiscard]] Edge edge_between(Places q0, Places q1, std::size_t p, std::size_t q) const;
  [[nodiscard]] std::size_t along_i(std::size_t i, std::size_t j) const { return j * shape_.columns + i; }
  [[nodiscard]] std::size_t along_j(std::size_t i, std::size_t j) const {
    return shape_.columns * (shape_.rows + 1) + j * (shape_.columns + 1) + i;
  }

  plan_lattice::Shape shape_;
  std::shared_ptr<const PlanBottom> bottom_;
  std::vector<Edge> edges_;
};

}  // namespace seiche::dispersive_shallow_water_2d
