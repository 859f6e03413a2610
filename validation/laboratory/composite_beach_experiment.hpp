/// The experiment of the composite beach: of wave A and C with what our one-dimensional dispersive model makes of them.
#pragma once

#include <string>

#include "validation/laboratory/experiment.hpp"

namespace seiche::validation::laboratory {

inline const std::string composite_beach_source =
    "M. J. Briggs, C. E. Synolakis, U. Kanoglu, D. R. Green, in: Long-Wave Runup Models, World Scientific (1996) "
    "375-383; U. Kanoglu, C. E. Synolakis, J. Fluid Mech. 374 (1998) 1-28";

/// @param letter  of the wave, A, B or C. The run must have the parameter spacing [m], of the markers.
Experiment composite_beach_experiment(const std::string& letter);

}  // namespace seiche::validation::laboratory
