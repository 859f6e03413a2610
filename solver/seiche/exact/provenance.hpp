#pragma once

#include <string>

namespace seiche::exact {

/// Where an exact solution comes from and what it says, for listings and reports.
struct Provenance {
  std::string citation;  ///< author, year, title
  std::string formula;   ///< the formulas that are evaluated, in plain text
};

}  // namespace seiche::exact
