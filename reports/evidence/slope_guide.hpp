/// A line of given slope beside the points of a convergence study.
#pragma once

#include <vector>

#include "reports/evidence/figure.hpp"

namespace seiche::validation {

/// Over the range of sizes (h, tau; numbers of cells with a negative order), through `last` at the last of them.
void slope_guide(evidence::Panel& panel, int order, const std::vector<double>& sizes, double last);

}  // namespace seiche::validation
