/// The constrained Delaunay triangulation of a polygon with nodes inside: ears are cut off the outline, nodes inserted
/// one by one, edges flipped.
///
/// The work is n_b^2 for n_b nodes of the outline, and per node inside a walk from the one before: number neighbours
/// one after another.
///
/// When not to use it: to follow nodes that move (MovingTriangulation), which is a hundred times cheaper.
#pragma once

#include "seiche/geometry/triangulation.hpp"

namespace seiche {

/// @param outline  nodes of the boundary, counter-clockwise; all others are inside
/// Throws std::invalid_argument naming the nodes: fewer than three of them, coordinates that are not finite, nodes that
/// coincide (closer than 1e-12 of the extent), an outline that is clockwise, meets itself or names a node twice, nodes
/// on or outside it.
Triangulation triangulate_polygon(Places nodes, std::span<const int> outline);

/// Area enclosed by a closed chain of nodes, positive for counter-clockwise ones. Summed about its first node.
double enclosed_area(Places nodes, std::span<const int> outline);

}  // namespace seiche
