#include "validation/command/solvers_table.hpp"

#include <algorithm>
#include <array>
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

bool is_of_ladder(const std::string& quantity) {
  return quantity.starts_with("ladder_");
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
      if (std::find(ids.begin(), ids.end(), claim.id) == ids.end()) ids.push_back(claim.id);
    }
    for (const auto& [quantity, value] : one->measurements) ++shared[quantity];
  }
  for (const std::string& id : ids) {
    print_row(id, solvers, [&](const Summary& one) { return describe(find_claim(one, id)); });
  }
  print_costs(solvers);
  for (const auto& [quantity, count] : shared) {
    if (is_stated_cost(quantity) || (count < 2 && !is_of_ladder(quantity))) continue;
    print_row(quantity, solvers, [&, name = quantity](const Summary& one) { return measured(one, name); });
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
