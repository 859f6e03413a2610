/// Triangles with their neighbours, and the local flips that keep them Delaunay (Frank 1994, 5.2; Lawson 1977).
///
/// The edges of the outline are fixed: constrained Delaunay. An edge inside is flipped when the node across it is
/// strictly inside the circle of the triangle; nodes on one circle keep the edge they have, so that flips end.
///
/// References: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), 5.2; Lawson, Software for
/// C1 surface interpolation, Mathematical Software III (1977) 161.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/geometry/curve.hpp"

namespace seiche {

/// Places of nodes, x and y apart. Does not own them.
struct Places {
  std::span<const double> x;
  std::span<const double> y;
  [[nodiscard]] Point operator[](int node) const {
    const auto k = static_cast<std::size_t>(node);
    return {x[k], y[k]};
  }
  [[nodiscard]] int size() const { return static_cast<int>(x.size()); }
};

struct Triangle {
  std::array<int, 3> vertex;  ///< counter-clockwise
  std::array<int, 3> across;  ///< the triangle opposite each vertex, or Triangulation::outside
};

class Triangulation {
 public:
  static constexpr int outside = -1;

  /// Neighbours are found from the vertices. Throws std::invalid_argument where an edge has three triangles or two that
  /// run along it in the same direction.
  explicit Triangulation(std::span<const std::array<int, 3>> triangles);

  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  [[nodiscard]] int size() const { return static_cast<int>(triangles_.size()); }
  [[nodiscard]] const Triangle& operator[](int t) const { return triangles_[static_cast<std::size_t>(t)]; }

  /// Replaces the edge opposite vertex k of triangle t, which is none of the outline, by the other diagonal: of t =
  /// (a, b, c) and its neighbour across bc with the vertex d become (a, b, d) and (a, d, c).
  void flip(int t, int k);
  /// Flips until no edge can be improved; returns how many flips that took. All triangles must be counter-clockwise.
  long make_delaunay(Places nodes);
  /// Puts a node into triangle t, in its inside or on an inner edge of it, and flips around it.
  void insert(int node, int t, Places nodes);
  /// A triangle that is not counter-clockwise, or `outside` if there is none.
  [[nodiscard]] int first_inverted(Places nodes) const;

 private:
  struct Edge {
    int triangle;
    int opposite;
  };

  Triangle& at(int t) { return triangles_[static_cast<std::size_t>(t)]; }
  [[nodiscard]] bool wants_flip(int t, int k, Places nodes) const;
  /// Which vertex of `of` faces triangle t.
  [[nodiscard]] int facing(int of, int t) const;
  void relink(int of, int from, int to);
  long settle(Places nodes);

  std::vector<Triangle> triangles_;
  std::vector<Edge> doubtful_;  // stack of edges to look at
};

/// Vertex k of a triangle counted on from 0, 1, 2: 3 is 0.
inline std::size_t next(int k) {
  return k == 2 ? 0 : static_cast<std::size_t>(k) + 1;
}
inline std::size_t previous(int k) {
  return k == 0 ? 2 : static_cast<std::size_t>(k) - 1;
}

// The constrained Delaunay triangulation of a polygon with nodes inside: ears are cut off the outline, nodes inserted
// one by one, edges flipped.
//
// The work is n_b^2 for n_b nodes of the outline, and per node inside a walk from the one before: number neighbours
// one after another.
//
// When not to use it: to follow nodes that move (MovingTriangulation), which is a hundred times cheaper.

/// @param outline  nodes of the boundary, counter-clockwise; all others are inside
/// Throws std::invalid_argument naming the nodes: fewer than three of them, coordinates that are not finite, nodes that
/// coincide (closer than 1e-12 of the extent), an outline that is clockwise, meets itself or names a node twice, nodes
/// on or outside it.
Triangulation triangulate_polygon(Places nodes, std::span<const int> outline);

/// Area enclosed by a closed chain of nodes, positive for counter-clockwise ones. Summed about its first node.
double enclosed_area(Places nodes, std::span<const int> outline);

// A Delaunay triangulation that follows its nodes by local flips: the rearrangement of the Dirichlet mesh (Frank 1994,
// 5.2).
//
// The mesh of given places is the same whichever way the nodes came, but for the diagonals of nodes on one circle. Its
// cost is that of looking at every edge once; flips are rare. Where nodes go so far that a triangle turns over on the
// way, the way is halved.
//
// When not to use it: where the outline changes its nodes. A node inside that reaches the outline, or two nodes of the
// outline that meet, end the motion.
//
// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), 5.2; Pautov & Frank,
// Zh. Vychisl. Mat. Mat. Fiz. 28 (1988) 1730.

class MovingTriangulation {
 public:
  /// @param mesh  Delaunay at these places, with all nodes
  MovingTriangulation(Triangulation mesh, Places nodes);

  /// Moves the nodes along straight lines. Throws std::invalid_argument for another number of nodes, Infeasible: the
  /// mesh then is somewhere on the way, and as good as before.
  void move_to(Places nodes);

  [[nodiscard]] const Triangulation& mesh() const { return mesh_; }
  [[nodiscard]] Places nodes() const { return {x_, y_}; }
  /// Grows whenever the triangles are others than before: for whoever keeps what depends on them.
  [[nodiscard]] long flips() const { return flips_; }

 private:
  static constexpr double shortest_part = 1e-9;  // of the way: nodes may pass each other as closely as that

  Triangulation mesh_;
  std::vector<double> x_, y_;
  std::vector<double> next_x_, next_y_;
  long flips_ = 0;
};

}  // namespace seiche
