#include "validation/command/solvers_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>

namespace seiche::command {
namespace {

using evidence::Summary;

constexpr int widest_label = 34;

/// A row: its label, and for every record what to print.
void print_row(const std::string& label, const std::vector<const Summary*>& solvers,
               const std::function<std::string(const Summary&)>& entry) {
  fmt::print("  {:<{}}", label, widest_label);
  for (const Summary* one : solvers) {
    fmt::print(" {:>{}}", entry(*one), std::max<std::size_t>(18, one->solver.size()));
  }
  fmt::print("\n");
}

const Summary::Outcome* find_claim(const Summary& record, const std::string& id) {
  const auto found =
      std::find_if(record.claims.begin(), record.claims.end(), [&](const auto& c) { return c.id == id; });
  return found == record.claims.end() ? nullptr : &*found;
}

std::string describe(const Summary::Outcome* claim) {
  if (claim == nullptr) return "-";
  const double distance = std::abs(claim->measured - claim->expected);
  if (!(claim->limit > 0) || !std::isfinite(distance)) return claim->verdict;
  return fmt::format("{} {:.2g}", claim->verdict, distance / claim->limit);
}

void print_case(const std::vector<const Summary*>& solvers) {
  fmt::print("{}\n", solvers.front()->name);
  print_row("claim: error over limit", solvers,
            [](const Summary& one) { return one.tier == "quick" ? one.solver : one.solver + "@" + one.tier; });
  std::vector<std::string> ids;
  std::map<std::string, std::size_t> shared;
  for (const Summary* one : solvers) {
    for (const auto& claim : one->claims) {
      if (std::find(ids.begin(), ids.end(), claim.id) == ids.end()) ids.push_back(claim.id);
    }
    for (const auto& [quantity, value] : one->measurements) ++shared[quantity];
  }
  for (const std::string& id : ids) {
    print_row(id, solvers, [&](const Summary& one) { return describe(find_claim(one, id)); });
  }
  for (const auto& [quantity, count] : shared) {
    if (count < 2) continue;
    print_row(quantity, solvers, [&, name = quantity](const Summary& one) {
      const auto found = one.measurements.find(name);
      return found == one.measurements.end() ? "-" : fmt::format("{:.5g}", found->second);
    });
  }
}

}  // namespace

bool print_side_by_side(const std::vector<Summary>& records) {
  std::map<std::string, std::vector<const Summary*>> cases;
  for (const Summary& one : records) cases[one.name].push_back(&one);
  bool as_declared = true;
  bool any = false;
  for (auto& [name, solvers] : cases) {
    if (solvers.size() < 2) continue;
    any = true;
    std::stable_partition(solvers.begin(), solvers.end(), [](const Summary* s) { return s->solver == "seiche"; });
    print_case(solvers);
    for (const Summary* one : solvers) as_declared = as_declared && one->as_declared();
  }
  if (!any) fmt::print("no case has records of several solvers\n");
  return as_declared;
}

}  // namespace seiche::command
