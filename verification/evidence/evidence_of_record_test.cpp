#include <fstream>
#include <tuple>

#include "reports/evidence/evidence_of_record.hpp"
#include "verification/check.hpp"

namespace seiche::verification::evidence_of_record_test {

using Catch::Matchers::Contains;
using evidence::RecordedClaim;

RecordedClaim bound(double measured) {
  return {.name = "bore",
          .set = "bzz-fig-12",
          .claim = "front",
          .kind = "bound",
          .measured = measured,
          .uncertainty = 0.003,
          .expected = 1,
          .limit = 0.1,
          .verdict = "pass"};
}

RecordedClaim roundoff(double measured) {
  return {.name = "bore",
          .claim = "mass",
          .kind = "roundoff",
          .measured = measured,
          .expected = 0,
          .limit = 1e-12,
          .verdict = "pass"};
}

std::size_t changed(const RecordedClaim& before, const RecordedClaim& after) {
  return evidence::changes({before}, {after}).size();
}

TEST_CASE("the baseline is read back as it was written", "[evidence]") {
  RecordedClaim lost = bound(RecordedClaim::none);
  lost.claim = "lost";
  lost.verdict = "error";
  RecordedClaim known = bound(0.5);
  known.claim = "known";
  known.band = 0.2;
  known.verdict = "declared fail";
  RecordedClaim place = roundoff(29.544312345678912);
  place.claim = "place";
  place.expected = place.measured;
  const std::vector<RecordedClaim> claims{bound(1.0123456789), known, lost, roundoff(3.8412e-15), place};
  const std::string csv = evidence::to_csv(claims);
  const auto file = std::filesystem::temp_directory_path() / "seiche_evidence_of_record.csv";
  std::ofstream(file) << csv;
  const auto read = evidence::read_recorded_claims(file);
  CHECK(evidence::to_csv(read) == csv);
  CHECK(evidence::changes(claims, read).empty());
  CHECK((read[1].name == "bore" && read[1].set == "bzz-fig-12" && read[1].claim == "known" && read[1].kind == "bound"));
  CHECK((read[1].measured == 0.5 && read[1].uncertainty == 0.003 && read[1].expected == 1 && read[1].limit == 0.1));
  CHECK((read[1].band == 0.2 && read[1].verdict == "declared fail" && std::isnan(read[0].band)));
  for (const auto& [text, said] : {std::pair(csv + "bore,,x,bound,one,,1,1,,pass\n", "line 7: 'one' is not a number"),
                                   {csv + "bore,,x,bound,1,,1,1m,,pass\n", "line 7: '1m' is not a number"},
                                   {csv + "bore,,x,bound,1,,1,1,pass\n", "line 7: 9 entries, must be 10"},
                                   {csv + "bore,,x,bound,1,,1,1,,pass,\n", "line 7: 11 entries, must be 10"},
                                   {"", "line 1: must be 'case,"},
                                   {csv.substr(1), "line 1: must be 'case,"}}) {
    std::ofstream(file) << text;
    CHECK_THROWS_WITH(evidence::read_recorded_claims(file), Contains(said));
  }
  std::filesystem::remove(file);
}

TEST_CASE("claims are in the order of case, set and claim", "[evidence]") {
  RecordedClaim other = bound(1);
  other.name = "alpha";
  RecordedClaim later = roundoff(0);
  later.claim = "volume";
  std::vector<RecordedClaim> claims{later, bound(1), roundoff(0), other};
  evidence::sort(claims);
  CHECK((claims[0].name == "alpha" && claims[1].claim == "mass" && claims[2].claim == "volume"));
  CHECK(claims[3].set == "bzz-fig-12");
  evidence::Summary one, another;
  one.name = "bore";
  another.name = "alpha";
  one.error = another.error = "diverged";
  CHECK(evidence::recorded_claims({one, another}).front().name == "alpha");
}

TEST_CASE("a record that did not finish has a claim of its run", "[evidence]") {
  evidence::Summary stopped;
  stopped.name = "bore";
  stopped.shows = "bzz-fig-12";
  stopped.error = "diverged";
  const auto claims = evidence::recorded_claims({stopped});
  REQUIRE(claims.size() == 1);
  CHECK((claims[0].name == "bore" && claims[0].set == "bzz-fig-12" && claims[0].claim == "run"));
  CHECK(claims[0].verdict == "error");
  CHECK(evidence::recorded_claims({evidence::Summary{}}).empty());
}

TEST_CASE("digits resolve a thousandth of the limit, and round-off to its order of magnitude", "[evidence]") {
  CHECK_THAT(evidence::to_csv({roundoff(3.8412e-15)}), Contains(",3.84e-15,"));
  RecordedClaim sharp = bound(1.00000000123456);
  sharp.limit = 1e-9;
  CHECK_THAT(evidence::to_csv({sharp}), Contains(",1.000000001235,"));
}

TEST_CASE("a measured value has moved beyond combined uncertainty and its share of the limit", "[evidence]") {
  const double allowed = std::hypot(0.003, 0.003) + evidence::moved_share * 0.1;
  const auto known = [](double measured) {
    RecordedClaim claim = bound(measured);
    claim.band = 2;
    return claim;
  };
  for (const auto& [before, after, differ] :
       {std::tuple(bound(1), bound(1 + 0.99 * allowed), 0U), std::tuple(bound(1), bound(1 - 1.01 * allowed), 1U),
        std::tuple(roundoff(1e-14), roundoff(9e-13), 0U), std::tuple(roundoff(1e-14), roundoff(2e-12), 1U),
        std::tuple(known(0.5), known(0.69), 0U), std::tuple(known(0.5), known(0.71), 1U)}) {
    CAPTURE(before.measured, after.measured);
    CHECK(changed(before, after) == differ);
  }
}

TEST_CASE("an uncertainty that came, went, or grew behind a limit has changed", "[evidence]") {
  const auto stated = [](double uncertainty) {
    RecordedClaim claim = bound(1);
    claim.uncertainty = uncertainty;
    return claim;
  };
  const double none = RecordedClaim::none;
  // A tenth of the limit, 0.01, and a factor 1.5.
  for (const auto& [before, after, differ] :
       {std::tuple(none, none, 0U), std::tuple(none, 1e-9, 1U), std::tuple(1e-9, none, 1U),
        std::tuple(0.03, 0.0449, 0U), std::tuple(0.03, 0.0451, 1U), std::tuple(0.0451, 0.03, 1U),
        std::tuple(0.003, 0.0129, 0U), std::tuple(0.003, 0.0131, 1U), std::tuple(0., 0.011, 1U)}) {
    CAPTURE(before, after);
    CHECK(changed(stated(before), stated(after)) == differ);
  }
  const auto appeared = evidence::changes({stated(none)}, {stated(0.5)});
  REQUIRE(appeared.size() == 1);
  CHECK_THAT(appeared.front(), Contains("uncertainty none -> 0.5"));
}

TEST_CASE("values that cannot be compared count as changed", "[evidence]") {
  CHECK(changed(bound(RecordedClaim::none), bound(RecordedClaim::none)) == 0);
  CHECK(changed(bound(1), bound(RecordedClaim::none)) == 1);
  CHECK(evidence::changes({bound(1)}, {}).size() == 1);
  CHECK(evidence::changes({}, {bound(1)}).size() == 1);
  for (const auto& change : {+[](RecordedClaim& c) { c.verdict = "fail"; }, +[](RecordedClaim& c) { c.kind = "order"; },
                             +[](RecordedClaim& c) { c.limit = 0.11; }, +[](RecordedClaim& c) { c.expected = 1.1; },
                             +[](RecordedClaim& c) { c.band = 0.1; }}) {
    RecordedClaim after = bound(1);
    change(after);
    CHECK(changed(bound(1), after) == 1);
  }
}

TEST_CASE("the baseline verdict states the declaration and departures from it", "[evidence]") {
  for (const auto& [declared, found, as_declared, verdict] :
       {std::tuple("pass", "pass", true, "pass"), std::tuple("fail", "fail", true, "declared fail"),
        std::tuple("fail", "fail", false, "fail outside its band"),
        std::tuple("fail", "pass", false, "undeclared pass"), std::tuple("pass", "fail", false, "fail")}) {
    evidence::Summary record;
    evidence::Summary::Outcome& claim = record.claims.emplace_back();
    claim.declared = declared;
    claim.verdict = found;
    claim.as_declared = as_declared;
    CHECK(evidence::recorded_claims({record}).front().verdict == verdict);
  }
}

}  // namespace seiche::verification::evidence_of_record_test
