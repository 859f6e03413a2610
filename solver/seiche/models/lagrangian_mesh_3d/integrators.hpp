/// The integrators of the model, compiled once (integrators.cpp) and not in every file that steps it.
#pragma once

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"

namespace seiche::mechanics {

extern template class OneStep<lagrangian_mesh_3d::Model>;
extern template class ConservativeStep<lagrangian_mesh_3d::Model>;
extern template class SchemeStepper<lagrangian_mesh_3d::Model>;
extern template class Start<lagrangian_mesh_3d::Model>;
extern template class InvariantsWatch<lagrangian_mesh_3d::Model>;

}  // namespace seiche::mechanics
