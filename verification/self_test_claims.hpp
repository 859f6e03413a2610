/// The identities of an exact solution as claims.
#pragma once

#include <string>

#include "seiche/exact/reference_solution.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// One assertion for each identity of the solution's self-test.
template <exact::ReferenceSolution Solution>
void self_test_holds(Check& check, const std::string& id, const Solution& solution) {
  const exact::SelfTest identities = solution.self_test();
  CHECK(!identities.empty());
  for (const exact::Identity& identity : identities) {
    check.holds(id + ": The residual of the solution's identity is within its accuracy: " + identity.name + ".",
                {identity.defect}, evidence::Bound{identity.accuracy, identity.reason});
  }
}

}  // namespace seiche::verification
