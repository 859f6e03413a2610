// What is worse than an earlier score, and what is noise.
#include <limits>

#include "validation/scoring/baseline.hpp"
#include "verification/check.hpp"

namespace seiche::verification::baseline_test {

using namespace validation;
using evidence::Summary;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Summary::Outcome claim(double measured, const std::string& verdict, double uncertainty = unknown,
                       const std::string& kind = "bound") {
  Summary::Outcome outcome;
  outcome.id = "error";
  outcome.kind = kind;
  outcome.measured = measured;
  outcome.verdict = verdict;
  outcome.uncertainty = uncertainty;
  outcome.limit = 1;
  return outcome;
}

std::string change(const Summary::Outcome& before, const Summary::Outcome& after) {
  Summary was;
  Summary is;
  was.claims = {before};
  is.claims = {after};
  const std::vector<Since> all = changes_since(was, is);
  if (all.empty()) return "same";
  return all.front().kind == Since::Kind::worse             ? "worse"
         : all.front().kind == Since::Kind::unexpected_pass ? "unexpected pass"
                                                            : "other";
}

TEST_CASE("a score is worse than its baseline where an error grew beyond both uncertainties", "[evidence]") {
  Check check("score_baseline", "Worse than before, or noise",
              "One claim with a limit of 1, before and after: which changes count as worse, as an unexpected pass, as "
              "neither.");
  const auto is = [&](const std::string& text, const std::string& got, const std::string& expected) {
    check.holds(text, {got == expected ? 1.0 : 0.0}, Qualitative{expected, "it was made so"});
  };
  is("Equal numbers are reported as unchanged.", change(claim(0.5, "pass"), claim(0.5, "pass")), "same");
  is("A change below 1 % of the limit is reported as unchanged.", change(claim(0.5, "pass"), claim(0.509, "pass")),
     "same");
  is("A larger error is reported as worse, even if the claim is still met.",
     change(claim(0.5, "pass"), claim(0.6, "pass")), "worse");
  is("An error of opposite sign and equal size is reported as unchanged.",
     change(claim(0.5, "pass"), claim(-0.5, "pass")), "same");
  is("A change within both uncertainties is not reported as worse.",
     change(claim(0.5, "pass", 0.1), claim(0.62, "pass", 0.1)), "same");
  is("A change beyond both uncertainties is reported as a change.",
     change(claim(0.5, "pass", 0.1), claim(0.65, "pass", 0.1)), "worse");
  is("A verdict that changes within the uncertainties is reported.",
     change(claim(0.95, "pass", 0.1), claim(1.05, "fail", 0.1)), "other");
  is("A growing failure is reported as worse.", change(claim(2, "fail"), claim(3, "fail")), "worse");
  is("A newly met claim is reported as an unexpected pass.", change(claim(1.5, "fail"), claim(0.5, "pass")),
     "unexpected pass");
  is("A formerly inconclusive claim that is met is reported as an unexpected pass.",
     change(claim(0.5, "inconclusive"), claim(0.5, "pass")), "unexpected pass");
  is("A value that became NaN is reported as worse.", change(claim(0.5, "pass"), claim(unknown, "error")), "worse");
  is("A lost feature is reported as worse.",
     change(claim(0, "pass", unknown, "qualitative"), claim(1, "fail", unknown, "qualitative")), "worse");
  is("A change within round-off is reported as unchanged.",
     change(claim(0.1, "pass", unknown, "roundoff"), claim(0.9, "pass", unknown, "roundoff")), "same");
  Summary was;
  was.claims = {claim(0.5, "pass")};
  const std::vector<Since> gone = changes_since(was, {});
  is("A missing claim is reported as worse.",
     gone.size() == 1 && gone.front().kind == Since::Kind::worse ? "worse" : "other", "worse");
}

}  // namespace seiche::verification::baseline_test
