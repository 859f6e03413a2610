#include "validation/scoring/baseline.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

using Outcome = evidence::Summary::Outcome;

bool by_verdict_alone(const Outcome& claim) {
  return claim.kind == "roundoff" || claim.kind == "qualitative";
}

std::string errors(const Outcome& before, const Outcome& after) {
  return fmt::format("error {:.3g} -> {:.3g}", error_of(before), error_of(after));
}

void compare(const Outcome& was, const Outcome& is, std::vector<Since>& all) {
  const auto add = [&](Since::Kind kind, const std::string& words) { all.push_back({kind, is.id, words}); };
  const bool lost = std::isnan(error_of(is)) && !std::isnan(error_of(was));
  const bool broken = by_verdict_alone(is) && was.verdict == "pass" && is.verdict != "pass";
  if (lost || broken || degraded(was, is)) {
    add(Since::Kind::worse, fmt::format("{}, {} -> {}", errors(was, is), was.verdict, is.verdict));
  } else if (was.verdict != "pass" && is.verdict == "pass") {
    add(Since::Kind::unexpected_pass, fmt::format("{}, {} -> pass", errors(was, is), was.verdict));
  } else if (was.verdict != is.verdict) {
    add(Since::Kind::other,
        fmt::format("{} -> {}, within the uncertainties: {}", was.verdict, is.verdict, errors(was, is)));
  } else if (degraded(is, was)) {
    add(Since::Kind::other, errors(was, is) + ", better");
  }
}

}  // namespace

double error_of(const Outcome& claim) {
  return std::abs(claim.measured - claim.expected);
}

bool degraded(const Outcome& before, const Outcome& after, double factor) {
  constexpr double noise = 0.01;
  if (by_verdict_alone(after)) return false;
  const auto known = [](double uncertainty) { return std::isnan(uncertainty) ? 0 : uncertainty; };
  const double growth = error_of(after) - error_of(before);
  return error_of(after) > factor * error_of(before) && growth > noise * std::abs(after.limit) &&
         growth > std::hypot(known(before.uncertainty), known(after.uncertainty));
}

std::vector<Since> changes_since(const evidence::Summary& before, const evidence::Summary& after) {
  std::vector<Since> all;
  std::map<std::string, const Outcome*> old;
  for (const Outcome& claim : before.claims) old[claim.id] = &claim;
  for (const Outcome& claim : after.claims) {
    if (const auto was = old.extract(claim.id)) {
      compare(*was.mapped(), claim, all);
    } else {
      all.push_back({Since::Kind::other, claim.id, "new: " + claim.verdict});
    }
  }
  for (const auto& [id, claim] : old) all.push_back({Since::Kind::worse, id, "no longer claimed"});
  return all;
}

std::string unlike(const evidence::Summary& before, const evidence::Record& record) {
  if (!before.error.empty()) return before.error;
  for (const auto& [name, p] : record.parameters) {
    const auto was = before.parameters.find(name);
    if (was != before.parameters.end() && was->second == p.value) continue;
    const auto in_words = [](const auto& value) { return fmt::format("{}", value); };
    return fmt::format("scored with {} = {}, not {}", name,
                       was == before.parameters.end() ? "none" : std::visit(in_words, was->second),
                       std::visit(in_words, p.value));
  }
  return {};
}

}  // namespace seiche::validation
