/// The identities of an exact solution as claims.
#pragma once

#include <string>

#include "seiche/exact/reference_solution.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// One claim for each identity of the solution's self-test.
template <exact::ReferenceSolution Solution>
void claim_self_test(Check& check, const std::string& id, const Solution& solution, const std::string& source) {
  int number = 0;
  for (const exact::Identity& identity : solution.self_test()) {
    check.that({.id = "identity-" + id + "-" + std::to_string(++number),
                .text = "The solution satisfies its own identity: " + identity.name + ".",
                .quantity = "relative defect",
                .source = source},
               {.value = identity.defect}, evidence::Bound{.limit = identity.accuracy, .reason = identity.reason});
  }
  CHECK(number > 0);
}

}  // namespace seiche::verification
