/// The integrators of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/dispersive_shallow_water_1d/model.hpp"

namespace seiche::mechanics {

extern template class OneStep<dispersive_shallow_water_1d::Model>;
extern template class ConservativeStep<dispersive_shallow_water_1d::Model>;
extern template class SchemeStepper<dispersive_shallow_water_1d::Model>;
extern template class Start<dispersive_shallow_water_1d::Model>;
extern template class InvariantsWatch<dispersive_shallow_water_1d::Model>;

}  // namespace seiche::mechanics
