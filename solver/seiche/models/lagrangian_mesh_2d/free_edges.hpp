/// The edges of the mesh at its free sides: potential energy of the polygon of water (Frank 1994, formula 7), and
/// pressure on it.
///
///     Pi = rho g sum (x_b - x_a)(y_a^2 + y_a y_b + y_b^2)/6,   from a to b with the water below
///
/// Only sides that can move are summed: what fixed sides contribute is constant.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

class FreeEdges {
 public:
  explicit FreeEdges(const Mesh& mesh);

  [[nodiscard]] bool empty() const { return strips_.empty(); }
  /// First node that can belong to a free edge.
  [[nodiscard]] std::size_t first_node() const { return first_node_; }
  /// sum (x_b - x_a)(y_a^2 + y_a y_b + y_b^2)/6 [m^3].
  [[nodiscard]] double moment(const double* x, const double* y) const;
  /// Adds -weight times its gradient to the forces.
  void push_down(const double* x, const double* y, double weight, double* push_x, double* push_y) const;
  /// Adds weight times the force of a pressure p(x of the edge's middle): half p (dy, -dx) on either end of an edge.
  void press(const std::function<double(double)>& pressure, const double* x, const double* y, double weight,
             double* push_x, double* push_y) const;

 private:
  /// Edges between nodes first, first + stride, ..., passed so that the water is on the right hand.
  struct Strip {
    std::ptrdiff_t first;
    std::ptrdiff_t stride;
    std::size_t edges;
  };
  template <class Edge>
  void over_edges(const Edge& edge) const {
    for (const Strip& strip : strips_) {
      std::ptrdiff_t a = strip.first;
      for (std::size_t n = 0; n < strip.edges; ++n, a += strip.stride) edge(a, a + strip.stride);
    }
  }

  std::vector<Strip> strips_;
  std::size_t first_node_ = 0;
};

}  // namespace seiche::lagrangian_mesh_2d
