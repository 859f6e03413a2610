/// The integrators of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/projected_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/gauss_particles/model.hpp"

namespace seiche::mechanics {

extern template class OneStep<gauss_particles::Model>;
extern template class ProjectedStep<gauss_particles::Model>;
extern template class Start<gauss_particles::Model>;
extern template class InvariantsWatch<gauss_particles::Model>;

}  // namespace seiche::mechanics
