/// Dirichlet (Voronoi) cells of the nodes of a triangulation: areas without clipping, and their exact gradients
/// (Frank 1994, 5.2).
///
/// The cells are the circumcentric dual of the constrained Delaunay triangulation, in signed form. Of the triangle abc
/// with the angles A, B, C the cell of a has
///
/// @f[ \frac{|ab|^2 \cot C + |ac|^2 \cot B}{8} . @f]
///
/// That is the Voronoi cell of a node inside, and of a node of the outline its part within the polygon; where the angle
/// that faces an edge of the outline is obtuse, its signed continuation. All cells together are the polygon, exactly.
/// A flip happens where the edge between two cells has no length: areas and gradients pass it without a jump.
///
/// A cell depends on its own node and the ones joined to it by an edge. Gradients are kept by the node that moves: the
/// ring of node k is k itself, then its neighbours i, each with dA_i/dr_k.
///
/// Reference: Serrano, Espanol & Zuniga, Voronoi fluid particle model for Euler equations, J. Stat. Phys. 121 (2005)
/// 133, for the derivatives; A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), 5.2.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "seiche/geometry/triangulation.hpp"

namespace seiche {

class DirichletCells {
 public:
  /// Whose neighbour is who: to be called again when an edge was flipped. @param nodes  how many there are
  void connect(const Triangulation& mesh, int nodes);
  /// Areas and gradients at these places. @param mesh  the one that was connected
  void measure(const Triangulation& mesh, Places nodes);

  [[nodiscard]] std::span<const double> areas() const { return area_; }
  /// The ring of node k are the entries begin()[k] to begin()[k+1], the first of them k itself.
  [[nodiscard]] std::span<const int> begin() const { return begin_; }
  [[nodiscard]] std::span<const int> members() const { return member_; }
  /// dA_i/dr_k for entry i of the ring of k.
  [[nodiscard]] std::span<const Point> gradients() const { return gradient_; }

 private:
  std::vector<int> begin_;
  std::vector<int> member_;
  /// For each triangle, of its vertices i, j: the entry of vertex i in the ring of vertex j, at 3 i + j.
  std::vector<std::array<int, 9>> entry_;
  std::vector<double> area_;
  std::vector<Point> gradient_;
};

/// Areas alone. @param areas  as many as nodes, filled
void dirichlet_areas(const Triangulation& mesh, Places nodes, std::span<double> areas);

/// Centroids of the cells, from their signed pieces.
std::vector<Point> dirichlet_centroids(const Triangulation& mesh, Places nodes);

}  // namespace seiche
