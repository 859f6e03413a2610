/// The undeformed lattice nearest to a given one, which preconditions its systems.
#pragma once

#include "seiche/linear/constraint_solver.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"

namespace seiche::dispersive_shallow_water_2d {

/// Equal rectangles between four walls over a level bottom, of the lattice's mean sizes, depth H and inertia alpha:
///
///     symbol = H [4 (h2/h1) s1^2 c2^2 + 4 (h1/h2) s2^2 c1^2] + h1 h2 c1^2 c2^2/(alpha H),   s, c of half the phases
linear::UndeformedLattice undeformed_lattice(const Lattice& lattice, double inertia);

}  // namespace seiche::dispersive_shallow_water_2d
