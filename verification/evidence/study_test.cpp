// A case declares its claims, computes, shows: whatever goes wrong leaves no claim without a verdict.
#include "validation/case/study.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "validation/case/on_threads.hpp"
#include "verification/check.hpp"

namespace seiche::verification::study_test {

using namespace evidence;
using namespace validation;

struct Results {
  std::string what;
  double depth = 1.05, overshoot = 3;
};

Claim claim(const std::string& id) {
  return {.id = id, .text = "It holds.", .quantity = "depth", .unit = "m", .source = "test"};
}

const Bound bound{.limit = 0.1, .reason = "test", .expected = 1};

void claims(const Values& values, const Claims<Results>& claims) {
  const std::string& what = values.text("what");
  if (what == "nothing") return;
  const auto all = claims.only_if(what != "all left out", "no water");
  all.check(claim("depth"), &Results::depth, bound);
  if (what == "twice") all.check(claim("depth"), &Results::depth, bound);
  all.only_if(what != "left out", "for longer waves only")
      .check(
          claim("crest"),
          [](const Results& r) -> Measurement {
            if (r.what == "not measured") throw std::runtime_error("no crest found");
            return {.value = r.what == "not a number" ? std::numeric_limits<double>::quiet_NaN() : 1};
          },
          bound);
  all.check(
      claim("told"),
      [](const Results& r) -> Measurement {
        if (r.what == "not told") return {.value = 1};
        return {.value = 1, .told = {.limit = r.what == "beyond the cap" ? 0.3 : 0.1}};
      },
      Bound{Amount::told_by_run(0.2), "test", 1});
  all.fails({.value = 3, .width = 0.1, .reason = "test"}).check(claim("overshoot"), &Results::overshoot, bound);
}

Results compute(const Run& run) {
  const std::string& what = run.text("what");
  if (what == "no memory") throw std::bad_alloc();
  if (what == "crash") throw std::runtime_error("the depth became negative");
  if (what == "refused") throw std::invalid_argument("depth: must be positive");
  Results results{what};
  if (what == "another failure") results.overshoot = 2;
  return results;
}

void show(const Results& results, const Values& /*values*/, Exhibit& exhibit) {
  if (results.what == "not shown") throw std::runtime_error("no room");
  exhibit.measure("depth", results.depth);
  if (results.what != "shows nothing") exhibit.table({.id = "depth", .title = "Depth", .columns = {{"h", "m"}}});
}

const std::vector<std::string> all_of_them{
    "fine",         "nothing",      "all left out",    "twice",          "left out",
    "not measured", "not a number", "not told",        "beyond the cap", "crash",
    "no memory",    "refused",      "another failure", "not shown",      "shows nothing"};

/// @param standard  the case's own choice
Run run_of(const std::string& what, const std::string& standard = "fine") {
  Values values({validation::choice("what", standard, all_of_them, "what happens")}, Tier::quick);
  values.set("what", what);
  return {values, [](double) {}};
}

Record record_of(const std::string& what) {
  Record record;
  record.name = "test";
  Study(claims, compute, show).run(run_of(what), record);
  return record;
}

Verdict verdict(const Record& record, const std::string& id) {
  const auto& judged = record.claims();
  REQUIRE(std::count_if(judged.begin(), judged.end(), [&](const auto& c) { return c.claim.id == id; }) == 1);
  return std::find_if(judged.begin(), judged.end(), [&](const auto& c) { return c.claim.id == id; })->judgement.verdict;
}

TEST_CASE("every declared claim is evaluated exactly once, in the order of its declaration", "[study]") {
  const Record record = record_of("fine");
  std::vector<std::string> ids;
  for (const JudgedClaim& judged : record.claims()) ids.push_back(judged.claim.id);
  CHECK(ids == std::vector<std::string>{"depth", "crest", "told", "overshoot"});
  for (const char* id : {"depth", "crest", "told"}) CHECK(verdict(record, id) == Verdict::pass);
  CHECK(verdict(record, "overshoot") == Verdict::fail);
  CHECK(record.as_declared());
  CHECK(record.left_out().empty());
  CHECK(record.measurements().at("depth") == 1.05);
}

TEST_CASE("a claim that could not be measured is an error under its own name, the others are evaluated", "[study]") {
  for (const char* what : {"not measured", "not a number"}) {
    const Record record = record_of(what);
    CHECK(verdict(record, "crest") == Verdict::error);
    CHECK(verdict(record, "depth") == Verdict::pass);
    CHECK(verdict(record, "told") == Verdict::pass);
    CHECK(record.error.empty());
    CHECK_FALSE(record.as_declared());
  }
  CHECK(record_of("not measured").claims()[1].judgement.note == "no crest found");
}

TEST_CASE("a limit due from the run but not set is an error, one beyond its cap is inconclusive", "[study]") {
  CHECK(verdict(record_of("not told"), "told") == Verdict::error);
  CHECK(verdict(record_of("beyond the cap"), "told") == Verdict::inconclusive);
  CHECK_FALSE(record_of("beyond the cap").as_declared());
}

TEST_CASE("a run that crashes leaves every claim in error, known deviations too", "[study]") {
  const Record record = record_of("crash");
  CHECK(record.error == "the depth became negative");
  CHECK(record.claims().size() == 4);
  for (const JudgedClaim& judged : record.claims()) {
    CHECK(judged.judgement.verdict == Verdict::error);
    CHECK_FALSE(judged.as_declared());
  }
  CHECK_FALSE(record.as_declared());
}

TEST_CASE("a run that gets no memory says so", "[study]") {
  CHECK(record_of("no memory").error.starts_with("out of memory"));
}

TEST_CASE("a known deviation of another size than declared is unexpected", "[study]") {
  const Record record = record_of("another failure");
  CHECK(verdict(record, "overshoot") == Verdict::fail);
  CHECK_FALSE(record.as_declared());
}

TEST_CASE("a claim that does not apply is listed with its reason and not evaluated", "[study]") {
  const Record record = record_of("left out");
  REQUIRE(record.left_out().size() == 1);
  CHECK(record.left_out()[0].claim.id == "crest");
  CHECK(record.left_out()[0].reason == "for longer waves only");
  CHECK(record.claims().size() == 3);
  CHECK(record.as_declared());
}

TEST_CASE("a case that declares a claim twice or has no claims is rejected before it computes", "[study]") {
  for (const auto& [what, said] : {std::pair("twice", "claim 'depth' is declared twice"),
                                   std::pair("nothing", "the case makes no claim at these parameters"),
                                   std::pair("all left out", "the case makes no claim at these parameters")}) {
    CHECK_THROWS_WITH(Study(claims, compute, show).claims(run_of(what)), said);
    CHECK_THROWS_WITH(record_of(what), said);
  }
}

TEST_CASE("parameters that do not go together are the user's error, not the case's", "[study]") {
  CHECK_THROWS_AS(record_of("refused"), std::invalid_argument);
}

TEST_CASE("a rejection at the case's own parameters is the case's error: every claim is in error", "[study]") {
  Record record;
  record.name = "test";
  Study(claims, compute, show).run(run_of("refused", "refused"), record);
  CHECK(record.error == "depth: must be positive");
  CHECK(record.claims().size() == 4);
  for (const JudgedClaim& judged : record.claims()) CHECK(judged.judgement.verdict == Verdict::error);
  CHECK_FALSE(record.as_declared());
}

TEST_CASE("a case whose figures fail retains its verdicts and is not marked as finished", "[study]") {
  const Record record = record_of("not shown");
  CHECK(verdict(record, "depth") == Verdict::pass);
  CHECK_FALSE(record.error.empty());
  CHECK_FALSE(record.as_declared());
  CHECK(record_of("shows nothing").error == "its results could not be shown: no figure and no table");
}

TEST_CASE("independent computations run on as many threads as allowed, until the first that fails", "[evidence]") {
  std::mutex mutex;
  std::size_t at_work = 0, most = 0;
  std::vector<std::size_t> finished;
  const auto work = [&](std::size_t) {
    {
      const std::scoped_lock lock(mutex);
      if (++at_work > most) most = at_work;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::scoped_lock lock(mutex);
    --at_work;
  };
  on_threads(8, 2, work, [&](std::size_t n) { finished.push_back(n); });
  CHECK(most <= 2);
  CHECK(finished == std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8});
  std::vector<std::size_t> begun;
  const auto failing = [&](std::size_t k) {
    begun.push_back(k);
    if (k == 2) throw std::runtime_error("the third");
  };
  CHECK_THROWS_WITH(on_threads(5, 1, failing), "the third");
  CHECK(begun == std::vector<std::size_t>{0, 1, 2});
}

}  // namespace seiche::verification::study_test
