/// Assertions of a check that share a limit.
#pragma once

#include <string>
#include <vector>

#include "verification/check.hpp"

namespace seiche::verification {

struct Asserted {
  std::string what;  ///< a sentence
  double measured;
  double expected = 0;
};

/// @param limit  a Roundoff or a Bound, about what each of them expects
template <class Limit>
void all_hold(Check& check, Limit limit, const std::vector<Asserted>& all) {
  for (const auto& [what, measured, expected] : all) {
    limit.expected = expected;
    check.holds(what, {measured}, limit);
  }
}

}  // namespace seiche::verification
