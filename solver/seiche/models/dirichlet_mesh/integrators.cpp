#include "seiche/models/dirichlet_mesh/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<dirichlet_mesh::Model>;
template class Start<dirichlet_mesh::Model>;
template class InvariantsWatch<dirichlet_mesh::Model>;

}  // namespace seiche::mechanics
