/// Where the errors of a result stand among those of other solvers that were run on the case and stored.
#pragma once

#include <string>

#include "reports/evidence/record.hpp"

namespace seiche::validation {

/// The error of every quantity and how many solvers of reports/record/solvers.csv have a larger one at the same
/// settings (evidence::Standing); empty where none is stored.
std::string rank(const evidence::Record& record);

}  // namespace seiche::validation
