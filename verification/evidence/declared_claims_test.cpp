#include <set>

#include <fmt/format.h>

#include "validation/case/registry.hpp"
#include "verification/check.hpp"

using namespace seiche;

namespace {

std::string reason_of(const evidence::Criterion& criterion) {
  return std::visit([](const auto& c) { return c.reason; }, criterion);
}

/// Of every tier, at its defaults and at published sets.
std::vector<validation::Values> all_runs_of(const validation::Case& one) {
  std::vector<validation::Values> runs;
  for (const auto tier : {validation::Tier::quick, validation::Tier::full, validation::Tier::paper}) {
    for (const validation::Values& values : one.runs_of(tier)) runs.push_back(values);
  }
  return runs;
}

}  // namespace

TEST_CASE("every case declares its claims for every tier before it runs", "[evidence]") {
  for (const validation::Case& one : validation::all_cases()) {
    for (const validation::Values& values : all_runs_of(one)) {
      INFO(one.name << ", " << name(values.tier()) << " " << values.set_name());
      const std::vector<validation::DeclaredClaim> claims = one.study.claims(values);
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
}

TEST_CASE("declared failures fail within their whole band", "[evidence]") {
  for (const validation::Case& one : validation::all_cases()) {
    for (const validation::Values& values : all_runs_of(one)) {
      for (const validation::DeclaredClaim& declared : one.study.claims(values)) {
        // What only the run can tell decides where the band of the others ends.
        const auto* bound = std::get_if<evidence::Bound>(&declared.criterion);
        if (!declared.known_failure || bound == nullptr || !bound->limit.stated() || !bound->expected.stated())
          continue;
        INFO(one.name << ", " << name(values.tier()) << " " << values.set_name() << ", " << declared.claim.id);
        const evidence::KnownFailure& failure = *declared.known_failure;
        if (std::isinf(failure.width)) continue;
        for (const double end : {failure.value - failure.width, failure.value, failure.value + failure.width}) {
          CHECK(judge({.value = end}, declared.criterion).verdict == evidence::Verdict::fail);
        }
      }
    }
  }
}
