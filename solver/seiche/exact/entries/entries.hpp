/// The entries of the catalogue, one function and one file each.
#pragma once

#include "seiche/exact/catalogue.hpp"

namespace seiche::exact {

ExactSolution riemann_entry();
ExactSolution bore_reflection_entry();
ExactSolution simple_wave_entry();
ExactSolution steady_bump_entry();
ExactSolution macdonald_entry();
ExactSolution thacker_entry();

}  // namespace seiche::exact
