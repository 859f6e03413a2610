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

#include <memory>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/rows.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

class BottomVolume {
 public:
  struct Places {
    const double* x;
    const double* y;
  };

  BottomVolume(plan_lattice::Shape shape, std::shared_ptr<const PlanBottom> bottom);

  /// Subtracts the gradients of the volumes at `at` from those of the cells.
  void subtract_gradients(Places at, CellGradients& gradients);
  /// The same with discrete gradients over the segment from q0 to q1: Simpson's mean, corrected along the segment so
  /// that gradient times segment is the difference of the volumes to round-off.
  void subtract_gradients_between(Places q0, Places q1, CellGradients& gradients);
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
  /// work(edge number, p, q) for all edges: those along i first, then those along j.
  template <class Work>
  void for_each_edge(const Work& work) const;
  void subtract_edges(CellGradients& gradients) const;
  [[nodiscard]] std::size_t along_i(std::size_t i, std::size_t j) const { return j * shape_.columns + i; }
  [[nodiscard]] std::size_t along_j(std::size_t i, std::size_t j) const {
    return shape_.columns * (shape_.rows + 1) + j * (shape_.columns + 1) + i;
  }

  plan_lattice::Shape shape_;
  std::shared_ptr<const PlanBottom> bottom_;
  std::vector<Edge> edges_;
};

}  // namespace seiche::dispersive_shallow_water_2d
