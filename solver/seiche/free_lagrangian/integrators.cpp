#include "seiche/free_lagrangian/integrators.hpp"

namespace seiche::mechanics {

template class Start<free_lagrangian::CellWater>;
template class InvariantsWatch<free_lagrangian::CellWater>;

}  // namespace seiche::mechanics
