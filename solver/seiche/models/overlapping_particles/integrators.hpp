/// The integrators of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/overlapping_particles/model.hpp"

namespace seiche::mechanics {

extern template class OneStep<overlapping_particles::Model>;
extern template class Start<overlapping_particles::Model>;
extern template class InvariantsWatch<overlapping_particles::Model>;

}  // namespace seiche::mechanics
