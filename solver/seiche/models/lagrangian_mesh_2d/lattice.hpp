/// The undeformed lattice nearest to a mesh, which preconditions its large systems.
#pragma once

#include <optional>

#include "seiche/linear/constraint_solver.hpp"
#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

/// Columns of the mesh's mean width, rows of their mean heights; empty unless the mesh lies between walls at the left
/// and right and on a bottom, under a free surface.
std::optional<linear::UndeformedLattice> undeformed_lattice(const Mesh& mesh, double density);

}  // namespace seiche::lagrangian_mesh_2d
