/// The integrators of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/rigid_chain/rigid_chain.hpp"

namespace seiche::mechanics {

extern template class OneStep<rigid_chain::RigidChain>;
extern template class ConservativeStep<rigid_chain::RigidChain>;
extern template class SchemeStepper<rigid_chain::RigidChain>;
extern template class Start<rigid_chain::RigidChain>;
extern template class InvariantsWatch<rigid_chain::RigidChain>;

}  // namespace seiche::mechanics
