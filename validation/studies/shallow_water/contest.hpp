/// Several schemes compute the same flow at the same resolution.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/studies/shallow_water/flow.hpp"
#include "validation/studies/shallow_water/profile_measures.hpp"

namespace seiche::validation {

/// One scheme of a comparison, at the end of its run. Of one that broke down nothing is known: its numbers are NaN.
struct Contestant {
  std::string scheme;
  std::string failure;  ///< why it did not finish; empty if it did
  Profile profile;
  ProfileErrors errors = ProfileErrors::none();
  double front_error = std::numeric_limits<double>::quiet_NaN();  ///< NaN without a front too
  double width = std::numeric_limits<double>::quiet_NaN();        ///< the same
  double seconds = std::numeric_limits<double>::quiet_NaN();
  long steps = 0;

  [[nodiscard]] bool finished() const { return failure.empty(); }
};

/// Runs a scheme to `time`; a breakdown is kept as the contestant's failure.
Contestant contest(const FlowProblem& problem, const Discretisation& discretisation, double time, const Front* front);

/// The same for several schemes, each with the discretisation's other values.
std::vector<Contestant> contest_all(const FlowProblem& problem, const Discretisation& discretisation,
                                    const std::vector<std::string>& schemes, double time, const Front* front,
                                    const std::function<void(double)>& progress = {});

/// The one of that name. @throws std::out_of_range
const Contestant& by_scheme(const std::vector<Contestant>& contestants, const std::string& scheme);

/// Adds a table of errors, widths and front errors, and a figure with a panel of depth per scheme.
void report_contest(evidence::Exhibit& exhibit, const FlowProblem& problem, double time,
                    const std::vector<Contestant>& contestants, const std::vector<std::string>& atlas = {});

}  // namespace seiche::validation
