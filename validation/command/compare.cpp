#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/record_files.hpp"
#include "validation/case/refusal.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/streams.hpp"
#include "validation/scoring/baseline.hpp"

namespace seiche::command {
namespace {

using evidence::Summary;
using validation::degraded;
using validation::error_of;

/// A row: its label, and for every record what to print.
void print_row(const std::string& label, const std::vector<const Summary*>& solvers,
               const std::function<std::string(const Summary&)>& entry) {
  constexpr int widest_label = 34;
  fmt::print("  {:<{}}", label, widest_label);
  for (const Summary* one : solvers) {
    fmt::print(" {:>{}}", entry(*one), std::max<std::size_t>(18, one->solver.size()));
  }
  fmt::print("\n");
}

std::string describe(const Summary& record, const std::string& id) {
  const auto claim = std::ranges::find(record.claims, id, &Summary::Outcome::id);
  if (claim == record.claims.end()) return "-";
  const double distance = error_of(*claim);
  if (!(claim->limit > 0) || !std::isfinite(distance)) return claim->verdict;
  return fmt::format("{} {:.2g}", claim->verdict, distance / claim->limit);
}

std::string measured(const Summary& one, const std::string& quantity) {
  const auto found = one.measurements.find(quantity);
  return found == one.measurements.end() ? "-" : fmt::format("{:.5g}", found->second);
}

/// What each result took and how fast its error falls, where a solver said: shown even if the others did not.
constexpr std::array<std::pair<const char*, const char*>, 2> stated_costs{
    {{"cell_size", "cost: cell [m]"}, {"threads", "cost: threads"}}};

bool is_stated_cost(const std::string& quantity) {
  return std::ranges::any_of(stated_costs, [&](const auto& cost) { return quantity == cost.first; });
}

void print_costs(const std::vector<const Summary*>& solvers) {
  print_row("cost: time [s]", solvers,
            [](const Summary& one) { return one.wall_time > 0 ? fmt::format("{:.3g}", one.wall_time) : "-"; });
  for (const auto& [quantity, label] : stated_costs) {
    const bool anybody =
        std::ranges::any_of(solvers, [&](const Summary* one) { return one->measurements.contains(quantity); });
    if (anybody) print_row(label, solvers, [&](const Summary& one) { return measured(one, quantity); });
  }
}

void print_case(const std::vector<const Summary*>& solvers) {
  fmt::print("{}\n", solvers.front()->name);
  print_row("claim: error over limit", solvers,
            [](const Summary& one) { return one.tier == "quick" ? one.solver : one.solver + "@" + one.tier; });
  std::vector<std::string> ids;
  std::map<std::string, std::size_t> shared;
  for (const Summary* one : solvers) {
    for (const auto& claim : one->claims) {
      if (std::ranges::find(ids, claim.id) == ids.end()) ids.push_back(claim.id);
    }
    for (const auto& [quantity, value] : one->measurements) ++shared[quantity];
  }
  for (const std::string& id : ids) {
    print_row(id, solvers, [&](const Summary& one) { return describe(one, id); });
  }
  print_costs(solvers);
  for (const auto& [quantity, count] : shared) {
    if (is_stated_cost(quantity) || (count < 2 && !quantity.starts_with("ladder_"))) continue;
    print_row(quantity, solvers, [&, name = quantity](const Summary& one) { return measured(one, name); });
  }
}

/// Prints, for every case that several solvers have a record of, a column per solver: verdict and distance from what is
/// expected in units of the limit per claim; what it took, time, cells and threads, as it was stated; orders of
/// ladders; the measurements that they share.
///
/// @returns whether every one of these records is as declared; true where there are none
bool print_side_by_side(const std::vector<Summary>& records) {
  std::map<std::string, std::vector<const Summary*>> cases;
  for (const Summary& one : records) cases[one.name].push_back(&one);
  std::erase_if(cases, [](const auto& one) { return one.second.size() < 2; });
  if (cases.empty()) fmt::print("no case has records of several solvers\n");
  bool as_declared = true;
  for (auto& [name, solvers] : cases) {
    std::ranges::stable_partition(solvers, [](const Summary* s) { return s->solver == "seiche"; });
    print_case(solvers);
    as_declared = as_declared && std::ranges::all_of(solvers, &Summary::as_declared);
  }
  return as_declared;
}

std::vector<Summary> records_in(const std::string& directory) {
  std::vector<Summary> records = evidence::read_summaries(directory, evidence::Reading::all_files);
  if (records.empty()) validation::fail("compare: folder {} holds no record", directory);
  const auto unsealed = std::ranges::count(records, false, &Summary::sealed);
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
    const auto ending = [](const Summary& one) { return one.error.empty() ? "finished" : one.error; };
    line("run", fmt::format("'{}' -> '{}'", ending(before), ending(after)));
    worse = worse || !after.error.empty();
  }
  std::map<std::string, const Summary::Outcome*> old;
  for (const auto& claim : before.claims) old[claim.id] = &claim;
  for (const auto& claim : after.claims) {
    const auto found = old.extract(claim.id);
    if (!found) {
      line(claim.id, fmt::format("new: {}", claim.verdict));
      worse = worse || !claim.as_declared;
      continue;
    }
    const Summary::Outcome& was = *found.mapped();
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
    if (after.contains(key)) continue;
    fmt::print("  {:<24} no longer there\n", key);
    worse = true;
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
