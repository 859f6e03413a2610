/// The experiment of the submerged bar of Luth, Klopman and Kitou with what our one-dimensional dispersive model makes
/// of its waves.
#pragma once

#include <string>

#include "validation/laboratory/experiment.hpp"

namespace seiche::validation::laboratory {

inline const std::string luth_bar_source =
    "H. R. Luth, G. Klopman, N. Kitou, Delft Hydraulics report H1573 (1994); S. Beji, J. A. Battjes, Coastal Eng. 19 "
    "(1993) 151-162";

/// @param letter  of the wave, A or C. The run must have the parameters spacing [m], of the markers, and dispersion.
Experiment luth_bar_experiment(const std::string& letter);

}  // namespace seiche::validation::laboratory
