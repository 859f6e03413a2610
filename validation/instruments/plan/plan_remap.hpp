/// Carries a flow of the plan model from its lattice to another one between the same sides.
///
/// Lagrangian columns shear and tangle; the flow continues on a rezoned mesh. Surface and velocities are interpolated
/// from the old nodes (lattice_interpolant.hpp). Volume and momentum pass through the quadrilaterals that the edges of
/// the cells sweep on the way,
///
/// @f[ V_s^* = V_s + \sum_e \pm \int_e H \, dA, \qquad
///     \mathbf{P}_s^* = \mathbf{P}_s + \sum_e \pm \int_e H \mathbf{u} \, dA, @f]
///
/// with no flux through walls and shorelines. The deficit d_s of the interpolated surface and velocities in a cell is
/// distributed over its corners that are not on a shoreline,
///
/// @f[ \delta z_k = \sum_s w_{sk} d_s \Big/ \frac{\partial V}{\partial z_k}, \qquad
///     \delta \mathbf{u}_k = \sum_s w_{sk} \mathbf{d}_s / m_k, \qquad \sum_k w_{sk} = 1. @f]
///
/// No column falls dry. A cell loses three quarters of its water at most; a larger swept volume is reduced to that. A
/// column that would sink by more than its depth stops above the bottom, and the surplus of its cell comes from the
/// neighbouring cells. Water displaced in these two ways carries its momentum; Remapped::displaced is its amount.
///
/// Conserved to round-off: all water; horizontal momentum, where neither a wall nor a shoreline takes part and the
/// bottom is level; a mesh that does not move; a stream of one velocity under a level surface over a level bottom.
/// Smooth fields are carried to third order. Over a sheet of water that is thin for its cells the interpolated depth
/// stays within a factor of two of the bilinear one. Energy is not conserved: the caller records the loss where
/// velocities differ within a cell.
///
/// References: C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227 (rezoned Lagrangian lattices);
/// L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266 (remap through swept regions).
#pragma once

#include <vector>

#include "seiche/models/dispersive_shallow_water_2d/model.hpp"

namespace seiche::validation {

/// A lattice and what its nodes carry.
struct Remapped {
  dispersive_shallow_water_2d::Lattice lattice;
  std::vector<dispersive_shallow_water_2d::Velocity> velocity;
  double displaced = 0;  ///< water elsewhere than it was swept [m^3]
};

/// @param model, q, u  where the flow is; its volumes are model.first_volumes()
/// @param x, y         the new places in plan, each within a few cells of the old one: of nodes on sides on them, of
///                     those on a shoreline near it
/// Throws mechanics::Infeasible where that is not so, where a cell would tangle and where a column would have no water.
Remapped remap(const dispersive_shallow_water_2d::Model& model, mechanics::Input q, mechanics::Input u,
               std::vector<double> x, std::vector<double> y);

}  // namespace seiche::validation
