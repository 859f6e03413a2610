/// Carries a flow of the plan model from its lattice to another one between the same sides.
///
/// Lagrangian columns shear and crumple; a rezoned lattice stands at better places, and what the old one
/// carries has to be put on it. Surface and velocities come from the old nodes (lattice_interpolant.hpp). What they
/// conserve is carried through the quadrilaterals that the edges of the cells sweep on their way,
///
/// @f[ V_s^* = V_s + \sum_e \pm \int_e H \, dA, \qquad
///     \mathbf{P}_s^* = \mathbf{P}_s + \sum_e \pm \int_e H \mathbf{u} \, dA, @f]
///
/// through walls and shorelines nothing. What the interpolated surface and velocities have too little of them in a
/// cell, d_s, its corners get that are not on a shoreline,
///
/// @f[ \delta z_k = \sum_s w_{sk} d_s \Big/ \frac{\partial V}{\partial z_k}, \qquad
///     \delta \mathbf{u}_k = \sum_s w_{sk} \mathbf{d}_s / m_k, \qquad \sum_k w_{sk} = 1. @f]
///
/// No column falls dry. A cell loses three quarters of its water at most: what the sweep would take more stays where it
/// is. A column that should sink by more than its depth stops before, and its cell gets what it then has too much from
/// the cells around it. Water that is so put elsewhere than it was swept takes its momentum along, and its
/// amount is told.
///
/// Conserved to round-off: all water; horizontal momentum, where neither a wall nor a shoreline takes part and the
/// bottom is level; a lattice that stays as it is; a stream of one velocity under a level surface over a level bottom.
/// Smooth fields are carried to third order. Over a sheet of water that is thin for its cells the interpolated depth
/// keeps within a factor of two of the bilinear one. Energy is not conserved: what is lost where velocities differ
/// within a cell is the caller's to book.
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
