/// Carries a flow from its mesh to another one of the same water.
///
/// Lagrangian cells shear and fold; a rezoned mesh (rezone.hpp) has its nodes at better places. Velocities there come
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
#pragma once

#include <vector>

#include "seiche/models/lagrangian_mesh_2d/model.hpp"

namespace seiche::lagrangian_mesh_2d {

/// A mesh and the velocities of its nodes.
struct Remapped {
  Mesh mesh;
  std::vector<Point> velocity;
};

/// @param model, q, u  where the flow is
/// @param x, y         the new places, each within a few cells of the old one: of nodes on walls on them, of surface
///                     nodes on the surface
/// Throws mechanics::Infeasible where that is not so and where a cell would fold; std::invalid_argument for fewer than
/// three columns or rows.
Remapped remap(const Model& model, Input q, Input u, std::vector<double> x, std::vector<double> y);

}  // namespace seiche::lagrangian_mesh_2d
