/// The undeformed lattice nearest to a mesh, which preconditions its systems.
#pragma once

#include "seiche/linear/constraint_solver.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Cells of the mesh's mean sides in plan, layers of their mean heights.
linear::UndeformedLattice undeformed_lattice(const Mesh& mesh, double density);

}  // namespace seiche::lagrangian_mesh_3d
