// The judge is judged: these tests use plain Catch2, not the machinery they check.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reports/evidence/record.hpp"
#include "verification/check.hpp"

using namespace seiche::evidence;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
const Claim claim{.id = "depth", .text = "The depth is right.", .quantity = "depth", .unit = "m", .source = "none"};

}  // namespace

TEST_CASE("a bound passes inside, fails outside, and is inconclusive when the uncertainty straddles it", "[verdict]") {
  const Bound bound{.limit = 0.1, .reason = "test", .expected = 2.0};
  CHECK(judge({.value = 2.05}, bound).verdict == Verdict::pass);
  CHECK(judge({.value = 2.2}, bound).verdict == Verdict::fail);
  CHECK(judge({.value = 2.05, .uncertainty = 0.04}, bound).verdict == Verdict::pass);
  CHECK(judge({.value = 2.05, .uncertainty = 0.07}, bound).verdict == Verdict::inconclusive);
  CHECK(judge({.value = 2.2, .uncertainty = 0.05}, bound).verdict == Verdict::fail);
  CHECK(judge({.value = not_a_number}, bound).verdict == Verdict::fail);
  CHECK(judge({.value = 2.0, .uncertainty = not_a_number}, bound).verdict != Verdict::pass);
  CHECK(judge({.value = 2.0, .uncertainty = std::numeric_limits<double>::infinity()}, bound).verdict ==
        Verdict::inconclusive);
}

TEST_CASE("a relative bound is relative to the expected value", "[verdict]") {
  const Bound bound{.limit = 0.01, .reason = "test", .expected = -50.0, .relative = true};
  CHECK(judge({.value = -50.4}, bound).verdict == Verdict::pass);
  CHECK(judge({.value = -50.6}, bound).verdict == Verdict::fail);
  CHECK(judge({.value = -50.6}, bound).limit == 0.5);
}

TEST_CASE("a round-off limit grows with the square root of the operations", "[verdict]") {
  const double eps = std::numeric_limits<double>::epsilon();
  const Roundoff roundoff{.operations = 1e4, .scale = 10, .reason = "test"};
  CHECK(judge({.value = 3.9e3 * eps}, roundoff).verdict == Verdict::pass);
  CHECK(judge({.value = 4.1e3 * eps}, roundoff).verdict == Verdict::fail);
}

TEST_CASE("agreement within an uncertainty too large to decide is inconclusive", "[verdict]") {
  const Uncertainty decisive{.expected = 1, .data = 0.03, .input = 0.04, .useful = 0.2, .reason = "test"};
  CHECK(judge({.value = 1.09}, decisive).verdict == Verdict::pass);  // 2 sqrt(0.03^2 + 0.04^2) = 0.1
  CHECK(judge({.value = 1.11}, decisive).verdict == Verdict::fail);
  CHECK(judge({.value = 1.15, .uncertainty = 0.3}, decisive).verdict == Verdict::inconclusive);
  const Uncertainty vague{.expected = 1, .data = 0.5, .useful = 0.2, .reason = "test"};
  CHECK(judge({.value = 1.0}, vague).verdict == Verdict::inconclusive);
}

TEST_CASE("a criterion without a reason is refused", "[verdict]") {
  CHECK_THROWS_AS(judge({.value = 1}, Bound{.limit = 1}), std::invalid_argument);
  CHECK_THROWS_AS(judge({.value = 1}, Roundoff{}), std::invalid_argument);
  CHECK_THROWS_AS(judge({.value = 1}, Uncertainty{}), std::invalid_argument);
  CHECK_THROWS_AS(judge({.value = 1}, Qualitative{}), std::invalid_argument);
  CHECK_THROWS_AS(judge(ObservedOrder{}, Order{}), std::invalid_argument);
}

TEST_CASE("a later success does not overwrite an earlier failure", "[record]") {
  Record record;
  record.name = "test";
  const Bound bound{.limit = 0.1, .reason = "test"};
  CHECK(record.check(claim, {.value = 0.01}, bound) == Verdict::pass);
  CHECK(record.check(claim, {.value = 5.0}, bound) == Verdict::fail);
  CHECK(record.check(claim, {.value = 0.01}, bound) == Verdict::fail);
  CHECK(record.claims().size() == 1);
  CHECK(record.claims()[0].judgement.measured == 5.0);
  CHECK_FALSE(record.as_declared());
}

TEST_CASE("a declared failure that passes is not as declared", "[record]") {
  Record record;
  record.name = "test";
  const Bound bound{.limit = 0.1, .reason = "test"};
  record.known_failure(claim, {.value = 5.0}, bound, "the method cannot do it");
  CHECK(record.as_declared());
  Record surprised;
  surprised.name = "test";
  surprised.known_failure(claim, {.value = 0.0}, bound, "the method cannot do it");
  CHECK_FALSE(surprised.as_declared());
  CHECK_THROWS_AS(record.known_failure({.id = "x"}, {.value = 5.0}, bound, ""), std::invalid_argument);
}

TEST_CASE("a run that broke down is never as declared", "[record]") {
  Record record;
  record.name = "test";
  record.check(claim, {.value = 0}, Bound{.limit = 1, .reason = "test"});
  CHECK(record.as_declared());
  record.error = "depth became negative";
  CHECK_FALSE(record.as_declared());
}
