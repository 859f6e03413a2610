/// The integrator of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/free_lagrangian/integrators.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/models/dirichlet_mesh/model.hpp"

namespace seiche::mechanics {

extern template class OneStep<dirichlet_mesh::Model>;

}  // namespace seiche::mechanics
