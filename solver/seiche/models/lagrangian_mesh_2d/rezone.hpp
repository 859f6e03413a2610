/// Where the nodes of a layer go when its mesh is rezoned: columns upright again, rows at their parts of the depth.
///
/// Surface nodes run ahead of the water beneath them, crowd in the sheet that a high wave throws up a wall and turn the
/// corners of their cells inside out, though the water does nothing of the kind. In the rezoned mesh every column is
/// again a line with the direction that it had in the first mesh, where no water has passed it on the whole; the line
/// ends on the bottom and on the surface, and the nodes between have the parts of its length that they had at first.
/// Columns over a level bottom cannot tangle as long as the surface has one elevation at every place.
///
/// The surface is the cubic through its nodes; what its new polygon has too little water in an edge, the ends of the
/// edge rise for. The water is kept to round-off. A layer at rest is left alone.
///
/// When not to use it: water whose surface overturns; where Frank's own model is meant.
///
/// Reference: C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227.
#pragma once

#include <memory>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "seiche/plan_lattice/swept_remap.hpp"

namespace seiche::lagrangian_mesh_2d {

class UprightColumns {
 public:
  using Places = plan_lattice::RezonedPlaces;

  /// Throws std::invalid_argument for a mesh that is not water between two straight walls, on a bottom, under a free
  /// surface, for walls that go on into the bottom, and for fewer than three columns or rows.
  explicit UprightColumns(const Mesh& first);
  /// For a flow whose nodes are at q.
  [[nodiscard]] Places places(mechanics::Input q) const;
  /// Farthest of a node from its place, over the shortest edge there.
  [[nodiscard]] double drift(mechanics::Input q, const Places& places) const {
    return plan_lattice::farthest(shape_, q, places);
  }

 private:
  [[nodiscard]] Point old(mechanics::Input q, std::size_t i, std::size_t j) const {
    const std::size_t k = shape_.node(i, j);
    return {q[k], q[shape_.nodes() + k]};
  }
  /// Of a column that keeps its water, and the column's upper end.
  Point foot(mechanics::Input q, const plan_lattice::RowCurve& surface, std::size_t i, Point& top) const;
  void level(mechanics::Input q, std::vector<Point>& top) const;

  plan_lattice::Shape shape_;
  std::shared_ptr<const Curve> bottom_;
  std::vector<Point> direction_;  ///< of the columns, per height
  std::vector<double> part_;      ///< of a column's length below a node
};

/// Carries a flow from its mesh to another one of the same water.
///
/// Lagrangian cells shear and tangle; a rezoned mesh (rezone.hpp) has its nodes at better places. Velocities there come
/// from the old nodes (plan_lattice/lattice_interpolant.hpp), cubic between them. The momentum of a cell is carried
/// through the quadrilaterals that its edges sweep on their way,
///
/// @f[ V_s^* = V_s + \sum_e \pm \int_e dA, \qquad \mathbf{P}_s^* = \mathbf{P}_s + \rho \sum_e \pm \int_e \mathbf{u} \,
/// dA, @f]
///
/// and what the interpolated velocities have too little of it, d_s, the cell's corners get:
///
/// @f[ \delta \mathbf{u}_k = \frac{1}{4 m_k} \sum_s \mathbf{d}_s. @f]
///
/// Conserved to round-off: a mesh that stays as it is; water of one velocity; momentum but for what the edges of the
/// surface sweep and what walls take. Smooth velocities are carried to third order. Energy is not conserved: what is
/// lost where velocities differ within a cell is the caller's to book.
///
/// References: C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227 (rezoned Lagrangian meshes);
/// L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266 (remap through swept regions).
///
/// A mesh and the velocities of its nodes.
struct Remapped {
  Mesh mesh;
  std::vector<Point> velocity;
};

/// @param model, q, u  where the flow is
/// @param x, y         the new places, each within a few cells of the old one: of nodes on walls on them, of surface
///                     nodes on the surface
/// Throws mechanics::Infeasible where that is not so and where a cell would tangle; std::invalid_argument for fewer
/// than three columns or rows.
Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y);

}  // namespace seiche::lagrangian_mesh_2d
