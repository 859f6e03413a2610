#include <set>

#include <fmt/format.h>

#include "validation/case/registry.hpp"
#include "verification/check.hpp"

namespace seiche::verification::declared_claims_test {

std::string reason_of(const evidence::Criterion& criterion) {
  return std::visit([](const auto& c) { return c.reason; }, criterion);
}

struct Declared {
  std::string run;  ///< in words
  std::vector<validation::DeclaredClaim> claims;
};

/// Of every case in every tier, at its defaults and at published sets; some need exact solutions for their limits.
const std::vector<Declared>& all_declared() {
  static const std::vector<Declared> all = [] {
    std::vector<Declared> found;
    for (const validation::Case& one : validation::all_cases()) {
      for (const auto tier : {validation::Tier::quick, validation::Tier::full, validation::Tier::paper}) {
        for (const validation::Values& values : one.runs_of(tier)) {
          found.push_back(
              {fmt::format("{}, {} {}", one.name, name(tier), values.set_name()), one.study.claims(values)});
        }
      }
    }
    return found;
  }();
  return all;
}

TEST_CASE("every case declares its claims for every tier before it runs", "[evidence]") {
  for (const auto& [run, claims] : all_declared()) {
    INFO(run);
    CHECK_FALSE(claims.empty());
    std::set<std::string> ids;
    for (const validation::DeclaredClaim& declared : claims) {
      INFO(declared.claim.id);
      CHECK(ids.insert(declared.claim.id).second);
      CHECK_FALSE(declared.claim.text.empty());
      CHECK_FALSE(declared.claim.quantity.empty());
      CHECK_FALSE(reason_of(declared.criterion).empty());
      CHECK(static_cast<bool>(declared.measured));
      if (!declared.known_failure) continue;
      CHECK_FALSE(declared.known_failure->reason.empty());
      CHECK(std::isfinite(declared.known_failure->value));
      CHECK(declared.known_failure->width >= 0);
    }
  }
}

TEST_CASE("known deviations fail within their whole band", "[evidence]") {
  for (const auto& [run, claims] : all_declared()) {
    for (const validation::DeclaredClaim& declared : claims) {
      // What only the run can tell decides where the band of the others ends.
      const auto* bound = std::get_if<Bound>(&declared.criterion);
      if (!declared.known_failure || bound == nullptr || !bound->limit.stated() || !bound->expected.stated()) continue;
      INFO(run << ", " << declared.claim.id);
      const evidence::KnownFailure& failure = *declared.known_failure;
      if (std::isinf(failure.width)) continue;
      for (const double end : {failure.value - failure.width, failure.value, failure.value + failure.width}) {
        CHECK(judge({.value = end}, declared.criterion).verdict == evidence::Verdict::fail);
      }
    }
  }
}

}  // namespace seiche::verification::declared_claims_test
