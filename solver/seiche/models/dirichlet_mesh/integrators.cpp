#include "seiche/models/dirichlet_mesh/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<dirichlet_mesh::Model>;

}  // namespace seiche::mechanics
