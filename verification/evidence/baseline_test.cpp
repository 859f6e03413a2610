// What is worse than an earlier score, and what is noise.
#include <limits>

#include "validation/scoring/baseline.hpp"
#include "verification/check.hpp"
#include "verification/evidence/says.hpp"

namespace seiche::verification::baseline_test {

using namespace validation;
using evidence::Summary;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What is found of a claim with a limit of 1.
struct Found {
  double measured;
  std::string verdict;
  double uncertainty = unknown;
  std::string kind = "bound";
};

Summary with(const Found& found) {
  Summary summary;
  Summary::Outcome& outcome = summary.claims.emplace_back();
  outcome.id = "error";
  outcome.kind = found.kind;
  outcome.measured = found.measured;
  outcome.verdict = found.verdict;
  outcome.uncertainty = found.uncertainty;
  outcome.limit = 1;
  return summary;
}

std::string change(const Summary& before, const Summary& after) {
  const std::vector<Since> all = changes_since(before, after);
  if (all.empty()) return "same";
  return all.front().kind == Since::Kind::worse             ? "worse"
         : all.front().kind == Since::Kind::unexpected_pass ? "unexpected pass"
                                                            : "other";
}

TEST_CASE("a score is worse than its baseline where an error grew beyond both uncertainties", "[evidence]") {
  Check check("score_baseline", "Worse than before, or noise",
              "One claim with a limit of 1, before and after: which changes count as worse, as an unexpected pass, as "
              "neither.");
  const auto is = [&](const std::string& text, const Found& before, const Found& after, const std::string& expected) {
    says(check, text, change(with(before), with(after)), expected);
  };
  is("Equal numbers are reported as unchanged.", {0.5, "pass"}, {0.5, "pass"}, "same");
  is("A change below 1 % of the limit is reported as unchanged.", {0.5, "pass"}, {0.509, "pass"}, "same");
  is("A larger error is reported as worse, even if the claim is still met.", {0.5, "pass"}, {0.6, "pass"}, "worse");
  is("An error of opposite sign and equal size is reported as unchanged.", {0.5, "pass"}, {-0.5, "pass"}, "same");
  is("A change within both uncertainties is not reported as worse.", {0.5, "pass", 0.1}, {0.62, "pass", 0.1}, "same");
  is("A change beyond both uncertainties is reported as a change.", {0.5, "pass", 0.1}, {0.65, "pass", 0.1}, "worse");
  is("A verdict that changes within the uncertainties is reported.", {0.95, "pass", 0.1}, {1.05, "fail", 0.1}, "other");
  is("A growing failure is reported as worse.", {2, "fail"}, {3, "fail"}, "worse");
  is("A newly met claim is reported as an unexpected pass.", {1.5, "fail"}, {0.5, "pass"}, "unexpected pass");
  is("A formerly inconclusive claim that is met is reported as an unexpected pass.", {0.5, "inconclusive"},
     {0.5, "pass"}, "unexpected pass");
  is("A value that became NaN is reported as worse.", {0.5, "pass"}, {unknown, "error"}, "worse");
  is("A lost feature is reported as worse.", {0, "pass", unknown, "qualitative"}, {1, "fail", unknown, "qualitative"},
     "worse");
  is("A change within round-off is reported as unchanged.", {0.1, "pass", unknown, "roundoff"},
     {0.9, "pass", unknown, "roundoff"}, "same");
  says(check, "A missing claim is reported as worse.", change(with({0.5, "pass"}), {}), "worse");
  CHECK(changes_since(with({0.5, "pass"}), {}).size() == 1);
}

}  // namespace seiche::verification::baseline_test
