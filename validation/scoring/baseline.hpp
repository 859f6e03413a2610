/// What changed in a score since an earlier one of the same case and solver.
#pragma once

#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "reports/evidence/record_files.hpp"

namespace seiche::validation {

/// Distance of a claim's measured value from what is expected.
double error_of(const evidence::Summary::Outcome& claim);

/// An error grew by more than the factor, and by more than both uncertainties together and a hundredth of its limit:
/// below that it is noise. Of a claim to round-off and of a feature the verdict alone tells.
bool degraded(const evidence::Summary::Outcome& before, const evidence::Summary::Outcome& after, double factor = 1);

struct Since {
  enum class Kind { worse, unexpected_pass, other };
  Kind kind = Kind::other;
  std::string claim;
  std::string words;
};

/// Claim by claim. Worse is an error that grew beyond both uncertainties, that is no number any more, a feature or a
/// round-off that was kept and is not, and a claim that is gone. A verdict that changes while the error stays within
/// the uncertainties is shown and is not worse. An unexpected pass is a claim that the earlier score did not meet.
std::vector<Since> changes_since(const evidence::Summary& before, const evidence::Summary& after);

/// Why the numbers of a baseline are none to compare with a record's: other parameters, or none at all. Empty where
/// they are.
std::string unlike(const evidence::Summary& before, const evidence::Record& record);

}  // namespace seiche::validation
