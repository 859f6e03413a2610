// Whatever a case asks of others, its own reference must pass and a wrong result must not.

#include <fmt/format.h>

#include "validation/case/registry.hpp"
#include "verification/check.hpp"
#include "verification/evidence/submissions.hpp"

namespace seiche::verification::submissions_test {

using namespace validation;

long passed(const Case& one, const Values& values, const std::vector<WantedTable>& wanted, double factor,
            long& claims) {
  SolverFacts facts;  // known to the last digit, and said so
  for (const WantedTable& table : wanted) {
    if (table.abscissa) facts.uncertainty[table.abscissa->name] = {};
    for (const WantedQuantity& quantity : table.quantities) facts.uncertainty[quantity.column.name] = {};
  }
  const evidence::Record record =
      scored(one, values, wanted,
             submission(wanted, [&](const WantedQuantity& q, Place p) { return factor * q.reference(p); }), facts);
  claims = static_cast<long>(record.claims().size());
  long passes = 0;
  for (const evidence::JudgedClaim& claim : record.claims()) {
    UNSCOPED_INFO(fmt::format("{} x {}: {} {}", one.name, factor, claim.claim.id, claim.judgement.measured));
    if (claim.judgement.verdict == evidence::Verdict::pass) ++passes;
  }
  return passes;
}

TEST_CASE("every case that scores others passes its own reference and fails one that is half too large", "[evidence]") {
  Check check("submissions", "The references score perfectly, wrong results do not",
              "For every case that takes others' results, its own reference is submitted, which must meet every claim, "
              "and the reference times 1.5, which must fail at least one.");
  for (const Case& one : all_cases()) {
    if (!one.submission) continue;
    const Values values = one.values(Tier::quick);
    const std::vector<WantedTable> wanted = one.submission.tables(values);  // keeps what its references cost
    long claims = 0;
    const long exact = passed(one, values, wanted, 1, claims);
    check.holds(fmt::format("{}: the reference meets all {} claims.", one.name, claims),
                {static_cast<double>(claims - exact)}, Bound{0, "the reference has the quantities asked for"});
    const long wrong = passed(one, values, wanted, 1.5, claims);
    check.holds(fmt::format("{}: a result 50 % too large fails.", one.name), {wrong < claims ? 1.0 : 0.0},
                Qualitative{"fewer claims pass than there are", "half too large is outside every tolerance asked for"});
  }
}

}  // namespace seiche::verification::submissions_test
