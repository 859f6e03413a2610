#include "seiche/models/gauss_particles/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<gauss_particles::Model>;
template class ProjectedStep<gauss_particles::Model>;
template class Start<gauss_particles::Model>;
template class InvariantsWatch<gauss_particles::Model>;

}  // namespace seiche::mechanics
