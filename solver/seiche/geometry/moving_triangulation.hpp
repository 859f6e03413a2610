/// A Delaunay triangulation that follows its nodes by local flips: the rearrangement of the Dirichlet mesh (Frank 1994,
/// 5.2).
///
/// The mesh of given places is the same whichever way the nodes came, but for the diagonals of nodes on one circle. Its
/// cost is that of looking at every edge once; flips are rare. Where nodes go so far that a triangle turns over on the
/// way, the way is halved.
///
/// When not to use it: where the outline changes its nodes. A node inside that reaches the outline, or two nodes of the
/// outline that meet, end the motion.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), 5.2; Pautov & Frank,
/// Zh. Vychisl. Mat. Mat. Fiz. 28 (1988) 1730.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "seiche/geometry/triangulation.hpp"

namespace seiche {

/// The nodes cannot go on without a change of the outline.
class MeshTangled : public std::runtime_error {
 public:
  MeshTangled(const std::string& what, double place) : std::runtime_error(what), place_(place) {}
  /// x of a node of the triangle that turns over.
  [[nodiscard]] double place() const { return place_; }

 private:
  double place_;
};

class MovingTriangulation {
 public:
  /// @param mesh  Delaunay at these places, with all nodes
  MovingTriangulation(Triangulation mesh, Places nodes);

  /// Moves the nodes along straight lines. Throws std::invalid_argument for another number of nodes, MeshTangled: the
  /// mesh then is somewhere on the way, and as good as before.
  void move_to(Places nodes);

  [[nodiscard]] const Triangulation& mesh() const { return mesh_; }
  [[nodiscard]] Places nodes() const { return {x_, y_}; }
  /// Grows whenever the triangles are others than before: for whoever keeps what depends on them.
  [[nodiscard]] long flips() const { return flips_; }
  /// How often a way was halved.
  [[nodiscard]] long bisections() const { return bisections_; }

 private:
  static constexpr double shortest_part = 1e-9;  // of the way: nodes may pass each other as closely as that

  [[noreturn]] void throw_tangled(int triangle, Places there) const;

  Triangulation mesh_;
  std::vector<double> x_, y_;
  std::vector<double> next_x_, next_y_;
  long flips_ = 0;
  long bisections_ = 0;
};

}  // namespace seiche
