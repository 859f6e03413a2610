#include "seiche/models/rigid_chain/integrators.hpp"

namespace seiche::mechanics {

template class OneStep<rigid_chain::RigidChain>;
template class ConservativeStep<rigid_chain::RigidChain>;
template class SchemeStepper<rigid_chain::RigidChain>;
template class Start<rigid_chain::RigidChain>;
template class InvariantsWatch<rigid_chain::RigidChain>;

}  // namespace seiche::mechanics
