/// Where a result stands among those of other solvers: what is compared, and between whom.
#pragma once

#include <map>
#include <string>

#include "reports/evidence/record.hpp"

namespace seiche::evidence {

struct Standing {
  /// Parameters that are not their defaults: results are compared where these are the same. Our own say how it was
  /// computed and not what, and are left out.
  std::string settings;
  /// Of every quantity the relative error, of a curve in L1, the largest over gauges and instants; of an experiment the
  /// difference that its readings share alone ("readings"), since a curve holds the time that a gate takes as well.
  /// NaN where one was not found.
  std::map<std::string, double> errors;
};

Standing standing_of(const Record& record);

}  // namespace seiche::evidence
