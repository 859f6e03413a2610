#include "seiche/models/dispersive_shallow_water_1d/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<dispersive_shallow_water_1d::Model>;
template class ConservativeStep<dispersive_shallow_water_1d::Model>;
template class SchemeStepper<dispersive_shallow_water_1d::Model>;
template class Start<dispersive_shallow_water_1d::Model>;
template class InvariantsWatch<dispersive_shallow_water_1d::Model>;

}  // namespace seiche::mechanics
