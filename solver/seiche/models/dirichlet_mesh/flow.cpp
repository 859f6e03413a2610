#include "seiche/models/dirichlet_mesh/flow.hpp"

template class seiche::mechanics::OneStep<seiche::dirichlet_mesh::Model>;
