/// First velocities of a mesh of water in potential flow, from the potential on its surface.
///
/// An impulsive pressure -rho phi on the free surface sets water at rest into the potential flow with phi there. On the
/// mesh it gives velocities that the mesh itself could have got from rest. Velocities of the exact flow, sampled at the
/// nodes, are not such ones: in a potential flow of the mesh surface nodes, which feel the pressure half a cell below,
/// are slower along the surface by O(h). Given the exact velocity, they slide over the row beneath for ever.
///
/// Reference: Lamb, Hydrodynamics, 6th ed. (1932), art. 11, on impulsive pressures.
#pragma once

#include <functional>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

/// Velocities of the nodes of a mesh between walls, for Flow and Model::state.
/// @param potential  on the surface, at place x [m^2/s]
std::vector<Point> impulsive_start(const Mesh& mesh, const std::function<double(double x)>& potential);

}  // namespace seiche::lagrangian_mesh_2d
