#include "seiche/models/overlapping_particles/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<overlapping_particles::Model>;
template class Start<overlapping_particles::Model>;
template class InvariantsWatch<overlapping_particles::Model>;

}  // namespace seiche::mechanics
