#include "seiche/models/overlapping_particles/flow.hpp"

template class seiche::mechanics::OneStep<seiche::overlapping_particles::Model>;
template class seiche::mechanics::Start<seiche::overlapping_particles::Model>;
template class seiche::mechanics::InvariantsWatch<seiche::overlapping_particles::Model>;
