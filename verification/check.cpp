#define CATCH_CONFIG_EXTERNAL_INTERFACES  // of Catch2 2: listeners
#include "verification/check.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "validation/case/claims.hpp"

namespace seiche::verification {
namespace {

#if __has_include(<catch2/catch_all.hpp>)
using Listener = Catch::EventListenerBase;
#else
using Listener = Catch::TestEventListenerBase;
#endif

bool full = false;  ///< what the tag of the running test says: its records belong to that tier

class ReadTag : public Listener {
 public:
  using Listener::Listener;
  void testCaseStarting(const Catch::TestCaseInfo& test) override {
    Listener::testCaseStarting(test);
    full = test.tagsAsString().find("[full]") != std::string::npos;
  }
};
CATCH_REGISTER_LISTENER(ReadTag)

std::filesystem::path evidence_directory() {
  const char* chosen = std::getenv("SEICHE_EVIDENCE");  // NOLINT(concurrency-mt-unsafe): tests are single-threaded
  return chosen != nullptr ? chosen : SEICHE_EVIDENCE_DIRECTORY;
}

}  // namespace

Check::Check(const std::string& name, const std::string& title, const std::string& article, std::string source,
             std::source_location where)
    : begin_(std::chrono::steady_clock::now()), exceptions_(std::uncaught_exceptions()), source_(std::move(source)) {
  record_.name = name;
  record_.kind = "verification";
  if (full) record_.tier = "full";
  record_.group = std::filesystem::path(where.file_name()).parent_path().filename().string();
  record_.title = title;
  record_.source = where.file_name();
  record_.article = article;
  assertions_ = {"assertions",
                 "Assertions",
                 "Each is evaluated as a claim is; a presence is 1.",
                 {{"holds", ""}, {"measured", ""}, {"expected", ""}, {"limit", ""}, {"criterion", ""}, {"reason", ""}},
                 {},
                 {}};
}

Check::~Check() {
  record_.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  if (std::uncaught_exceptions() > exceptions_) record_.error = "the test ended by an exception";
  try {
    if (!assertions_.rows.empty()) {
      record_.check({.id = "assertions",
                     .text = assertions_.rows.size() == 1
                                 ? fmt::format("{}: the one assertion of the table holds.", record_.title)
                                 : fmt::format("{}: all {} assertions of the table hold.", record_.title,
                                               assertions_.rows.size()),
                     .quantity = "largest part of a limit that is used",
                     .source = "table of assertions"},
                    {.value = used_.value()},
                    evidence::Bound{1,
                                    "each has its own limit and reason; round-off and presence count 0 where they are "
                                    "met, infinity where not"});
      record_.table(std::move(assertions_));
    }
    evidence::write(record_, evidence_directory());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "record %s could not be written: %s\n", record_.name.c_str(), failure.what());
    std::abort();  // evidence that is lost must not look like evidence
  }
}

void Check::expect(const std::string& id) {
  const auto& claims = record_.claims();
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const auto& c) { return c.claim.id == id; });
  const evidence::Judgement& j = found->judgement;
  CAPTURE(found->claim.text, j.measured, j.uncertainty.value_or(std::numeric_limits<double>::quiet_NaN()), j.expected,
          j.limit, j.note);
  CHECK(evidence::name(j.verdict) == evidence::name(found->declared()));
  CHECK(found->as_declared());
}

void Check::expect(const std::string& what, const char* kind, const std::string& reason, const evidence::Judgement& j) {
  const bool number = kind != std::string("roundoff") && kind != std::string("qualitative");
  const double infinity = std::numeric_limits<double>::infinity();
  used_.add(j.verdict != evidence::Verdict::pass ? infinity
            : number && j.limit > 0              ? (j.measured - j.expected) / j.limit
                                                 : 0);
  assertions_.rows.push_back({what, j.measured, j.expected, j.limit, kind, reason});
  CAPTURE(what, kind, j.measured, j.uncertainty.value_or(std::numeric_limits<double>::quiet_NaN()), j.expected, j.limit,
          j.note);
  CHECK(evidence::name(j.verdict) == evidence::name(evidence::Verdict::pass));
}

void Check::holds(const std::string& what, const evidence::Measurement& measurement,
                  const evidence::Criterion& criterion) {
  constexpr std::array kinds{"roundoff", "order", "bound", "uncertainty", "qualitative"};  // as the variant has them
  expect(what, kinds[criterion.index()], std::visit([](const auto& c) { return c.reason; }, criterion),
         judge(measurement, settled(criterion, measurement.told)));
}

void Check::holds(const std::string& what, const evidence::ObservedOrder& observed, const evidence::Order& criterion) {
  expect(what, "order", criterion.reason, judge(observed, criterion));
}

evidence::Claim Check::claim(const std::string& id, const std::string& text, const std::string& quantity) {
  const auto [name, unit] = validation::name_and_unit(quantity);
  return {id, text, name, unit.empty() ? "1" : unit, std::exchange(next_source_, {})};
}

void Check::that(const evidence::Claim& claim, const evidence::Measurement& measurement,
                 const evidence::Criterion& criterion) {
  record_.check(sourced(claim), resolved(measurement), criterion);
  expect(claim.id);
}

void Check::that(const evidence::Claim& claim, const evidence::ObservedOrder& observed,
                 const evidence::Order& criterion) {
  record_.check(sourced(claim), observed, criterion);
  expect(claim.id);
}

void Check::known_failure(const evidence::Claim& claim, const evidence::Measurement& measurement,
                          const evidence::Criterion& criterion, const evidence::KnownFailure& failure) {
  record_.known_failure(sourced(claim), resolved(measurement), criterion, failure);
  expect(claim.id);
}

}  // namespace seiche::verification
