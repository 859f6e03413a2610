#include "seiche/models/lagrangian_mesh_2d/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<lagrangian_mesh_2d::Model>;
template class ConservativeStep<lagrangian_mesh_2d::Model>;
template class SchemeStepper<lagrangian_mesh_2d::Model>;
template class Start<lagrangian_mesh_2d::Model>;
template class InvariantsWatch<lagrangian_mesh_2d::Model>;

}  // namespace seiche::mechanics
