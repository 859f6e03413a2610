#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/solvers_table.hpp"
#include "validation/command/streams.hpp"
#include "validation/scoring/baseline.hpp"

namespace seiche::command {
namespace {

using evidence::Summary;
using validation::degraded;
using validation::error_of;

std::vector<Summary> records_in(const std::string& directory) {
  std::vector<Summary> records = evidence::read_summaries(directory, evidence::Reading::all_files);
  if (records.empty()) throw std::invalid_argument(fmt::format("compare: folder {} holds no record", directory));
  const auto unsealed = std::count_if(records.begin(), records.end(), [](const Summary& s) { return !s.sealed; });
  if (unsealed > 0) {
    complain(fmt::format("{}: {} of {} records carry no digest: a change after they were written would not be seen",
                         directory, unsealed, records.size()));
  }
  return records;
}

/// By case, published set or tier, and solver.
std::map<std::string, Summary> by_stem(const std::string& directory) {
  std::map<std::string, Summary> records;
  for (Summary& s : records_in(directory)) records.emplace(s.stem(), std::move(s));
  return records;
}

/// Prints what changed in one record; returns whether anything got worse: a verdict than declared, or an error.
bool compare_record(const std::string& key, const Summary& before, const Summary& after, double factor) {
  bool worse = false;
  const auto line = [&](const std::string& id, const std::string& what) {
    fmt::print("  {:<24} {:<28} {}\n", key, id, what);
  };
  if (before.error != after.error) {
    line("run", fmt::format("'{}' -> '{}'", before.error.empty() ? "finished" : before.error,
                            after.error.empty() ? "finished" : after.error));
    worse = worse || !after.error.empty();
  }
  std::map<std::string, const Summary::Outcome*> old;
  for (const auto& claim : before.claims) old[claim.id] = &claim;
  for (const auto& claim : after.claims) {
    const auto found = old.find(claim.id);
    if (found == old.end()) {
      line(claim.id, fmt::format("new: {}", claim.verdict));
      worse = worse || !claim.as_declared;
      continue;
    }
    const Summary::Outcome& was = *found->second;
    if (was.verdict != claim.verdict || was.as_declared != claim.as_declared) {
      const char* surprise = claim.as_declared ? "" : ", not as declared";
      line(claim.id, fmt::format("verdict {} -> {}{}", was.verdict, claim.verdict, surprise));
      worse = worse || !claim.as_declared;
    }
    const double from = error_of(was);
    const double to = error_of(claim);
    const bool vanished = std::isnan(from) != std::isnan(to);
    const bool grown = degraded(was, claim, factor);
    if (vanished || grown || to > factor * from || from > factor * to) {
      line(claim.id, fmt::format("error {:.3g} -> {:.3g}{}", from, to, grown ? ", worse" : ""));
    }
    worse = worse || grown || (vanished && std::isnan(to));
    old.erase(found);
  }
  for (const auto& [id, claim] : old) {
    line(id, "no longer claimed");
    worse = true;
  }
  if (after.wall_time > 1.5 * before.wall_time + 0.1 || before.wall_time > 1.5 * after.wall_time + 0.1) {
    line("wall time", fmt::format("{:.2f} s -> {:.2f} s", before.wall_time, after.wall_time));
  }
  return worse;
}

}  // namespace

int compare(const CompareOptions& options) {
  if (options.after.empty()) return print_side_by_side(records_in(options.before)) ? 0 : 1;
  const auto before = by_stem(options.before);
  const auto after = by_stem(options.after);
  bool worse = false;
  fmt::print("{} -> {}\n", options.before, options.after);
  for (const auto& [key, record] : before) {
    if (after.count(key) == 0) {
      fmt::print("  {:<24} no longer there\n", key);
      worse = true;
    }
  }
  for (const auto& [key, record] : after) {
    const auto was = before.find(key);
    if (was == before.end()) {
      fmt::print("  {:<24} new, {}\n", key, record.as_declared() ? "as declared" : "NOT as declared");
      worse = worse || !record.as_declared();
    } else {
      worse = compare_record(key, was->second, record, options.factor) || worse;
    }
  }
  fmt::print("{}\n", worse ? "something got worse" : "nothing got worse");
  return worse ? 1 : 0;
}

}  // namespace seiche::command
