/// The integrators of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/dirichlet_mesh/model.hpp"

namespace seiche::mechanics {

extern template class OneStep<dirichlet_mesh::Model>;
extern template class Start<dirichlet_mesh::Model>;
extern template class InvariantsWatch<dirichlet_mesh::Model>;

}  // namespace seiche::mechanics
