#pragma once

#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/submission.hpp"

namespace seiche::validation {

/// Draws a submitted profile or series with its reference: a figure with a panel per quantity, or, where there are
/// several groups, a figure per quantity with a panel for each of the first six groups.
void draw_submitted(const WantedTable& wanted, const std::vector<SubmittedGroup>& groups, evidence::Exhibit& exhibit);

}  // namespace seiche::validation
