/// The order of convergence from as few as three resolutions, for what is shown and not judged.
#pragma once

#include <cstddef>
#include <vector>

#include "reports/evidence/claim.hpp"

namespace seiche::evidence {

/// As observed_order(), of `fewest` usable points or more. Of three the interval is wide: Student's factor is 12.7.
/// @throws std::invalid_argument for fewest below 3
ObservedOrder order_of_few(const std::vector<double>& sizes, const std::vector<double>& errors, std::size_t fewest,
                           double floor = 0);

}  // namespace seiche::evidence
