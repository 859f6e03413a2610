/// The identities of an exact solution as one claim.
#pragma once

#include <algorithm>
#include <string>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification {

/// Passes when every identity of the solution's self-test holds; names them with their reasons.
template <exact::ReferenceSolution Solution>
void claim_self_test(Check& check, const std::string& id, const Solution& solution, const std::string& source) {
  Largest worst;
  std::string names;
  std::string reasons;
  for (const exact::Identity& identity : solution.self_test()) {
    INFO(identity.name << ": defect " << identity.defect << ", limit " << identity.limit);
    CHECK(identity.holds());
    worst.add(identity.defect / identity.limit);
    names += (names.empty() ? "" : "; ") + identity.name;
    reasons += (reasons.empty() ? "" : "; ") + identity.name + ": " + identity.reason;
  }
  check.that({.id = "identities-" + id,
              .text = "The solution satisfies its own identities: " + names + ".",
              .quantity = "largest defect over its limit",
              .source = source},
             {.value = worst.value()}, evidence::Bound{.limit = 1, .reason = reasons});
}

}  // namespace seiche::verification
