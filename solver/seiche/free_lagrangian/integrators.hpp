/// What the models of this family take from the mechanics, compiled once (integrators.cpp) and not in every file.
#pragma once

#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/start.hpp"

namespace seiche::mechanics {

extern template class Start<free_lagrangian::CellWater>;
extern template class InvariantsWatch<free_lagrangian::CellWater>;

}  // namespace seiche::mechanics
