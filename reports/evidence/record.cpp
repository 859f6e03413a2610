#include "reports/evidence/record.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

namespace seiche::evidence {
namespace {

void require_identifier(const char* what, const std::string& id) {
  const bool fine = !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  if (!fine) throw std::invalid_argument(fmt::format("{} '{}': must be letters, digits, '-' and '_'", what, id));
}

}  // namespace

Verdict Record::check(const Claim& claim, const Measurement& measurement, const Criterion& criterion) {
  const Criterion used = settled(criterion, measurement.told);
  return keep({claim, used, judge(measurement, used)});
}

Verdict Record::check(const Claim& claim, const ObservedOrder& observed, const Order& criterion) {
  return keep({claim, criterion, judge(observed, criterion)});
}

Verdict Record::known_failure(const Claim& claim, const Measurement& measurement, const Criterion& criterion,
                              const KnownFailure& failure) {
  const Criterion used = settled(criterion, measurement.told);
  return keep({claim, used, judge(measurement, used), failure});
}

Verdict Record::known_failure(const Claim& claim, const ObservedOrder& observed, const Order& criterion,
                              const KnownFailure& failure) {
  return keep({claim, criterion, judge(observed, criterion), failure});
}

Verdict Record::keep(JudgedClaim judged) {
  require_identifier("claim id", judged.claim.id);
  if (judged.known_failure) {
    const KnownFailure& failure = *judged.known_failure;
    if (failure.reason.empty()) {
      throw std::invalid_argument(fmt::format("claim '{}': a declared failure needs its reason", judged.claim.id));
    }
    if (!std::isfinite(failure.value) || !(failure.width >= 0)) {
      throw std::invalid_argument(
          fmt::format("claim '{}': a declared failure of {:g} +- {:g}: the value must be finite, the width at least 0 "
                      "(infinite: no band)",
                      judged.claim.id, failure.value, failure.width));
    }
    Judgement& judgement = judged.judgement;
    if (judgement.verdict == Verdict::fail && !failure.holds(judgement.measured)) {
      judgement.note = fmt::format("outside the band {:g} +- {:g} in which it was declared to fail{}{}", failure.value,
                                   failure.width, judgement.note.empty() ? "" : "; ", judgement.note);
    }
  }
  const auto earlier = std::find_if(claims_.begin(), claims_.end(),
                                    [&](const JudgedClaim& other) { return other.claim.id == judged.claim.id; });
  if (earlier == claims_.end()) {
    claims_.push_back(std::move(judged));
    return claims_.back().judgement.verdict;
  }
  // A claim that failed once in a run has failed; a surprise is worse than what was declared. Of the gauges and times
  // of somebody else's result that come out alike, the one that is farthest off speaks.
  const auto rank = [this](const JudgedClaim& c) {
    const Judgement& j = c.judgement;
    const double share = solver == "seiche" || !(j.limit > 0) ? 0 : std::abs(j.measured - j.expected) / j.limit;
    return std::tuple(!c.as_declared(), j.verdict, share);
  };
  if (rank(judged) > rank(*earlier)) *earlier = std::move(judged);
  return earlier->judgement.verdict;
}

Figure& Exhibit::figure(const std::string& id, const std::string& figure_title, const std::string& caption,
                        const std::vector<std::string>& tiles) {
  require_identifier("figure id", id);
  const bool taken = std::any_of(figures_.begin(), figures_.end(), [&](const Figure& f) { return f.id == id; });
  if (taken) throw std::invalid_argument(fmt::format("figure id '{}' is used twice", id));
  return figures_.emplace_back(id, figure_title, caption, tiles);
}

Table& Exhibit::table(Table table) {
  require_identifier("table id", table.id);
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size()) {
      throw std::invalid_argument(
          fmt::format("table '{}': a row has {} entries, must have {}", table.id, row.size(), table.columns.size()));
    }
  }
  return tables_.emplace_back(std::move(table));
}

bool Record::as_declared() const {
  return error.empty() &&
         std::all_of(claims_.begin(), claims_.end(), [](const JudgedClaim& c) { return c.as_declared(); });
}

std::string stem_of(const std::string& name, const std::string& set, const std::string& tier,
                    const std::string& solver) {
  return name +
         (!set.empty()      ? "@" + set
          : tier == "quick" ? ""
                            : "@" + tier) +
         (solver == "seiche" ? "" : "." + solver);
}

}  // namespace seiche::evidence
