/// What a mesh of Dirichlet cells is given by: nodes, the outline of the water, and the straight walls that hold nodes.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "seiche/geometry/triangulation.hpp"

namespace seiche::free_lagrangian {

/// A straight line without ends.
struct Wall {
  Point through;
  Point direction;  ///< of any length but zero
};

/// The walls that a node is on, by their number: none, one along which it slides, or two that hold it.
struct Held {
  static constexpr int by_none = -1;
  int one = by_none;
  int other = by_none;
};

struct Mesh {
  std::vector<double> x, y;  ///< nodes
  std::vector<int> outline;  ///< nodes around the water, counter-clockwise; all others are inside
  std::vector<Wall> walls = {};
  std::vector<Held> held = {};  ///< one per node

  [[nodiscard]] std::size_t nodes() const { return x.size(); }
  [[nodiscard]] Places places() const { return {x, y}; }
  /// Whether each node is on the outline.
  [[nodiscard]] std::vector<bool> on_outline() const;
  /// Throws std::invalid_argument naming the node: arrays of other lengths, nodes on walls that are not there or that
  /// run through another place, nodes inside that a wall holds. The outline is for triangulate_polygon to judge.
  void require_valid() const;
};

/// Rows of nodes between a level bottom and a surface.
struct Layer {
  double begin = 0;
  double end = 1;
  double bottom = -1;
  double level = 0;  ///< of the undisturbed surface
  int columns = 8;
  int rows = 8;
  /// Above the level; empty for a flat surface. Rows divide the height evenly.
  std::function<double(double x)> elevation = {};
  /// Odd rows are shifted by half a column. A rectangular lattice is singular: the pressure of such a mesh is known
  /// only with stabilisation.
  bool staggered = true;
  bool right_wall = true;  ///< without it the right end is a free surface
};

/// Between vertical walls at its ends. Throws std::invalid_argument.
Mesh layer_mesh(const Layer& layer);
/// The same rows of nodes in a rectangle without walls.
Mesh free_patch(int columns, int rows, Point lower, Point upper, bool staggered = true);

// A channel whose level bottom has a step up: rows of nodes before and above it.

struct SteppedChannel {
  double begin = 0;
  double step = 10;  ///< x of the step's face
  double end = 20;
  double bottom = -1;
  double shelf = -0.5;  ///< height of the bottom behind the step
  double level = 0;     ///< of the undisturbed surface
  int rows = 8;  ///< over the whole depth; there is a row at the shelf's height, above and below it even spacings
};

/// Cells about as wide as high. Every other row is shifted by half a column, counted from the surface, which is not; on
/// a shelf of an odd number of rows its own is, with a narrow cell at the corner. Walls: bottom, left end, face of the
/// step, shelf, right end. Throws std::invalid_argument.
Mesh stepped_channel_mesh(const SteppedChannel& channel);

}  // namespace seiche::free_lagrangian
