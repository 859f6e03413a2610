/// A process's part of a lattice, of which it makes its own model.
#pragma once

#include "distributed/decomposition.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

namespace seiche::distributed {

dispersive_shallow_water_2d::Lattice part_of(const dispersive_shallow_water_2d::Lattice& lattice, const Patch& patch);
/// The same part of rectangular_lattice(rectangle), bit by bit, without the whole: for lattices that fit no process.
dispersive_shallow_water_2d::Lattice part_of(const dispersive_shallow_water_2d::Rectangle& rectangle,
                                             const Patch& patch);
lagrangian_mesh_3d::Mesh part_of(const lagrangian_mesh_3d::Mesh& mesh, const Patch& patch);

}  // namespace seiche::distributed
