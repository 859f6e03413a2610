/// First velocities of a Lagrangian mesh of water in potential flow, from the potential on its surface.
///
/// An impulsive pressure -rho phi on the free surface sets water at rest into the potential flow with phi there. On the
/// mesh it gives velocities that the mesh itself could have got from rest. Velocities of the exact flow, sampled at the
/// nodes, are not such ones: they hold vorticity of the mesh, rows slide over each other for ever, and cells are
/// sheared until they tangle. In a potential flow of the mesh surface nodes, which feel the pressure half a cell below,
/// are slower along the surface by O(h).
///
/// Reference: Lamb, Hydrodynamics, 6th ed. (1932), art. 11, on impulsive pressures.
#pragma once

#include <functional>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"

namespace seiche::validation {

/// Velocities of the nodes of a mesh between walls, for Flow and Model::state.
/// @param potential  on the surface, at place x [m^2/s]
std::vector<Point> impulsive_start(const lagrangian_mesh_2d::Mesh& mesh,
                                   const std::function<double(double x)>& potential);

/// The force of a pressure on a bilinear patch is shared among its corners by p int N_a dr x dr, N_a the corner's
/// bilinear function: with n_a = (r_{a+1} - r_a) x (r_{a-1} - r_a), p (4 n_a + 2 n_{a+1} + 2 n_{a-1} + n_{a+2})/36.
/// Nodes of driven sides have their side's velocities.
std::vector<Vector3> impulsive_start(const lagrangian_mesh_3d::Mesh& mesh,
                                     const std::function<double(double x, double y)>& potential);

}  // namespace seiche::validation
