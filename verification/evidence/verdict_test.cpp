// The judge is judged: these tests use plain Catch2, not the machinery they check.
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::verdict_test {

using namespace evidence;
constexpr auto pass = Verdict::pass, inconclusive = Verdict::inconclusive, fail = Verdict::fail;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
const Claim claim{.id = "depth", .text = "The depth is right.", .quantity = "depth", .unit = "m", .source = "none"};

/// A value, with its uncertainty where one was estimated, and what it must be judged to be.
struct Is {
  Verdict expected;
  double value;
  std::optional<double> uncertainty = {};
};

void check_verdicts(const Criterion& criterion, const std::vector<Is>& rows) {
  for (const auto& [expected, value, uncertainty] : rows) {
    CAPTURE(value, uncertainty.has_value(), uncertainty.value_or(0));
    CHECK(name(judge({.value = value, .uncertainty = uncertainty}, criterion).verdict) == name(expected));
  }
}

TEST_CASE("a bound passes inside, fails outside, and is inconclusive when the uncertainty straddles it", "[verdict]") {
  const Bound bound{.limit = 0.1, .reason = "test", .expected = 2.0};
  check_verdicts(bound, {Is{pass, 2.05}, Is{fail, 2.2}, Is{pass, 2.05, 0.04}, Is{inconclusive, 2.05, 0.07},
                         Is{fail, 2.2, 0.05}, Is{inconclusive, 2.0, infinite}});
}

TEST_CASE("a value that is not finite is an error, whatever the criterion", "[verdict]") {
  const Bound bound{.limit = 0.1, .reason = "test", .expected = 2.0};
  const Roundoff roundoff{.operations = 1, .scale = 1, .reason = "test"};
  const Uncertainty uncertainty{.expected = 2, .data = 0.1, .useful = 1, .reason = "test"};
  const Qualitative qualitative{.detector = "test", .reason = "test"};
  for (const double broken : {not_a_number, infinite, -infinite}) {
    for (const Criterion& criterion : std::vector<Criterion>{bound, roundoff, uncertainty, qualitative}) {
      check_verdicts(criterion, {Is{Verdict::error, broken, 0}});
    }
    check_verdicts(Bound{broken, "test", 2.0}, {Is{Verdict::error, 2}});
    check_verdicts(Bound{0.1, "test", broken}, {Is{Verdict::error, 2}});
    check_verdicts(Roundoff{.operations = broken, .reason = "test"}, {Is{Verdict::error, 0}});
    check_verdicts(Uncertainty{.expected = 2, .data = broken, .useful = 1, .reason = "t"}, {Is{Verdict::error, 2, 0}});
    CHECK(judge({.value = 0}, Roundoff{.scale = broken, .reason = "test"}).verdict != pass);
  }
  check_verdicts(bound, {Is{Verdict::error, 2, not_a_number}, Is{Verdict::error, 2, -0.1}});
  check_verdicts(uncertainty, {Is{Verdict::error, 2, not_a_number}});
}

TEST_CASE("an extreme with a NaN among its samples, or without samples, is an error", "[verdict]") {
  const Bound bound{.limit = 0.1, .reason = "test"};
  Worst worst;
  CHECK(judge({.value = worst.value()}, bound).verdict == Verdict::error);
  for (const double error : {0.01, not_a_number, 0.02}) worst.add(error);
  CHECK(judge({.value = worst.value()}, bound).verdict == Verdict::error);
}

TEST_CASE("a relative bound is relative to the expected value", "[verdict]") {
  const Bound bound{.limit = 0.01, .reason = "test", .expected = -50.0, .relative = true};
  check_verdicts(bound, {Is{pass, -50.4}, Is{fail, -50.6}});
  CHECK(judge({.value = -50.6}, bound).limit == 0.5);
}

TEST_CASE("a round-off limit grows with the square root of the operations", "[verdict]") {
  const double eps = std::numeric_limits<double>::epsilon();
  const Roundoff roundoff{.operations = 1e4, .scale = 10, .reason = "test"};
  check_verdicts(roundoff, {Is{pass, 3.9e3 * eps}, Is{fail, 4.1e3 * eps}});
}

// 2 sqrt(0.03^2 + 0.04^2) = 0.1 of data and inputs, and 0.2 that is the most with which anything is decided.
const Uncertainty decisive{.expected = 1, .data = 0.03, .input = 0.04, .useful = 0.2, .reason = "test"};
const Uncertainty vague{.expected = 1, .data = 0.5, .useful = 0.2, .reason = "test"};  // 2 u_data = 1

TEST_CASE("agreement within an uncertainty too large to decide is inconclusive", "[verdict]") {
  check_verdicts(decisive, {Is{pass, 1.09, 0}, Is{fail, 1.11, 0}, Is{inconclusive, 1.15, 0.3}});
  check_verdicts(vague, {Is{inconclusive, 1.0, 0}});
}

TEST_CASE("a difference beyond an uncertainty too large for agreement fails", "[verdict]") {
  check_verdicts(vague, {Is{inconclusive, 1.99, 0}, Is{fail, 2.01, 0}});
}

TEST_CASE("agreement within uncertainties is inconclusive where the numerical uncertainty was not estimated",
          "[verdict]") {
  check_verdicts(decisive, {Is{inconclusive, 1}, Is{inconclusive, 1.29}});
  CHECK_FALSE(judge({.value = 1}, decisive).uncertainty.has_value());
}

TEST_CASE("a difference beyond any uncertainty that decides fails, estimated or not", "[verdict]") {
  check_verdicts(decisive, {Is{fail, 1.31}, Is{fail, 0.69}, Is{Verdict::error, not_a_number}});
  CHECK_THAT(judge({.value = 1.31}, decisive).note, Catch::Contains("not estimated"));
  const Uncertainty capped{.expected = Amount::at_most(1, 0.5), .data = 0.03, .useful = 0.2, .reason = "test"};
  check_verdicts(capped, {Is{inconclusive, 5}});
}

TEST_CASE("a criterion set by the run decides up to its cap and no further", "[verdict]") {
  const Criterion rounding = Roundoff{Amount::told_by_run(100), 10, "test"};
  const double eps = std::numeric_limits<double>::epsilon();
  const auto told = [](const Criterion& criterion, const Measurement& measured) {
    return judge(measured, settled(criterion, measured.told)).verdict;
  };
  for (const auto& [expected, value, operations] :
       {std::tuple(pass, 390 * eps, 100.), std::tuple(fail, 410 * eps, 100.), std::tuple(inconclusive, 0., 101.),
        std::tuple(inconclusive, 1e9, 101.), std::tuple(Verdict::error, 0., not_a_number),
        std::tuple(Verdict::error, 0., infinite), std::tuple(Verdict::error, not_a_number, 101.)}) {
    CAPTURE(value, operations);
    CHECK(told(rounding, {.value = value, .told = {.operations = operations}}) == expected);
  }
  const Criterion extrapolated = Bound{Amount::told_by_run(0.01), "test", 1};
  CHECK(told(extrapolated, {.value = 1.005, .told = {.limit = 0.008}}) == pass);
  CHECK(told(extrapolated, {.value = 1.005, .told = {.limit = 0.02}}) == inconclusive);
  CHECK(told(extrapolated, {.value = 1.005, .told = {.limit = -0.02}}) != pass);
}

TEST_CASE("an amount due from the run but not set is rejected, and so is one set although it was stated", "[verdict]") {
  const Criterion open = Roundoff{Amount::told_by_run(100), 10, "test"};
  CHECK_THROWS_AS(settled(open, {}), std::invalid_argument);
  CHECK_THROWS_AS(settled(open, {.scale = 1}), std::invalid_argument);
  const Criterion stated = Bound{0.1, "test", 1};
  CHECK_THROWS_AS(settled(stated, {.limit = 0.2}), std::invalid_argument);
  CHECK_THROWS_AS(settled(stated, {.expected = 1}), std::invalid_argument);
  CHECK(std::get<Bound>(settled(stated, {})).limit.value() == 0.1);
  Record record;
  CHECK_THROWS_AS(record.check(claim, {.value = 0}, open), std::invalid_argument);
  CHECK_THROWS_AS(record.check(claim, {.value = 1, .told = {.limit = 9}}, stated), std::invalid_argument);
  CHECK(record.claims().empty());
}

TEST_CASE("a criterion without a reason is rejected", "[verdict]") {
  for (const Criterion& none : std::vector<Criterion>{Bound{.limit = 1}, Roundoff{}, Uncertainty{}, Qualitative{}}) {
    CHECK_THROWS_AS(judge({.value = 1}, none), std::invalid_argument);
  }
  CHECK_THROWS_AS(judge(ObservedOrder{}, Order{}), std::invalid_argument);
}

TEST_CASE("a later success does not overwrite an earlier failure", "[record]") {
  Record record;
  record.name = "test";
  const Bound bound{.limit = 0.1, .reason = "test"};
  CHECK(record.check(claim, {.value = 0.01}, bound) == pass);
  CHECK(record.check(claim, {.value = 5.0}, bound) == fail);
  CHECK(record.check(claim, {.value = 0.01}, bound) == fail);
  CHECK(record.claims().size() == 1);
  CHECK(record.claims()[0].judgement.measured == 5.0);
  CHECK_FALSE(record.as_declared());
}

TEST_CASE("a known deviation fails by as much as was declared, or is unexpected", "[record]") {
  const Bound bound{.limit = 0.1, .reason = "test"};
  const KnownFailure declared{.value = 5, .width = 0.5, .reason = "the method cannot do it"};
  const auto measured = [&](double value) {
    Record record;
    record.name = "test";
    record.known_failure(claim, {.value = value}, bound, declared);
    return record;
  };
  for (const double value : {4.5, 5.0, 5.5}) CHECK(measured(value).as_declared());
  for (const double value : {4.4, 5.6, 1e9, -5.0}) {
    const Record record = measured(value);
    CHECK_FALSE(record.as_declared());
    CHECK(record.claims()[0].judgement.verdict == fail);
    CHECK(record.claims()[0].judgement.note.find("outside the band") == 0);
  }
  const Record surprised = measured(0);
  CHECK_FALSE(surprised.as_declared());
  CHECK(surprised.claims()[0].judgement.verdict == pass);
  for (const double broken : {not_a_number, infinite}) {
    const Record record = measured(broken);
    CHECK_FALSE(record.as_declared());
    CHECK(record.claims()[0].judgement.verdict == Verdict::error);
  }
}

TEST_CASE("a known deviation needs a reason and a finite value, and no band", "[record]") {
  Record record;
  const Bound bound{.limit = 0.1, .reason = "test"};
  const auto declare = [&](const KnownFailure& failure) { record.known_failure(claim, {.value = 5}, bound, failure); };
  CHECK_THROWS_AS(declare({.value = 5, .width = 0.5}), std::invalid_argument);
  CHECK_THROWS_AS(declare({.value = 5, .width = -0.5, .reason = "test"}), std::invalid_argument);
  CHECK_THROWS_AS(declare({.value = 5, .width = not_a_number, .reason = "test"}), std::invalid_argument);
  CHECK_THROWS_AS(declare({.value = not_a_number, .width = 1, .reason = "test"}), std::invalid_argument);
  CHECK(record.claims().empty());
  // Without a band any failure is as declared; a pass is not.
  declare({.width = infinite, .reason = "cause unknown"});
  CHECK(record.as_declared());
  Record passed;
  passed.name = "test";
  passed.known_failure(claim, {.value = 0}, bound, {.width = infinite, .reason = "cause unknown"});
  CHECK_FALSE(passed.as_declared());
}

TEST_CASE("an order that is declared to be missed is missed by as much as was declared", "[record]") {
  const Order second{2, 0.1, "test"};
  const KnownFailure first{.value = 1, .width = 0.05, .reason = "the bed has a corner"};
  const auto as_declared = [&](double order, double half_width) {
    Record record;
    record.name = "test";
    record.known_failure(claim, ObservedOrder{.order = order, .half_width = half_width}, second, first);
    return record.as_declared();
  };
  CHECK(as_declared(1.02, 0.1));
  CHECK_FALSE(as_declared(1.2, 0.1));
  CHECK_FALSE(as_declared(2, 0.01));
  CHECK_FALSE(as_declared(not_a_number, infinite));
}

TEST_CASE("a run that broke down is never as declared", "[record]") {
  Record record;
  record.name = "test";
  record.check(claim, {.value = 0}, Bound{1, "test"});
  CHECK(record.as_declared());
  record.error = "depth became negative";
  CHECK_FALSE(record.as_declared());
}

TEST_CASE("what a criterion does not state is one operation, size 1, expected 0, coverage 2", "[evidence]") {
  const double epsilon = std::numeric_limits<double>::epsilon();
  const auto judged = [](const Criterion& criterion) { return judge({.value = 0.5, .uncertainty = 0}, criterion); };
  CHECK((judged(Roundoff{.reason = "r"}).limit == 4 * epsilon && judged(Roundoff{.reason = "r"}).expected == 0));
  CHECK((judged(Bound{.reason = "r"}).limit == 0 && judged(Bound{.reason = "r"}).expected == 0));
  const Judgement uncertain = judged(Uncertainty{.data = 0.5, .useful = 9, .reason = "r"});
  CHECK((uncertain.limit == 1 && uncertain.expected == 0));
  CHECK(judged(Uncertainty{.input = 0.25, .useful = 9, .reason = "r"}).limit == 0.5);
  CHECK(judged(Uncertainty{.data = 0.5, .reason = "r"}).verdict == inconclusive);
  CHECK(judged(Qualitative{.detector = "d", .reason = "r"}).expected == 1);
  CHECK((Order{}.theory == 2 && Order{}.tolerance == 0.1));
  const KnownFailure zero{.reason = "r"};
  CHECK((zero.holds(0) && !zero.holds(1e-300) && !zero.holds(-1e-300)));
}

}  // namespace seiche::verification::verdict_test
