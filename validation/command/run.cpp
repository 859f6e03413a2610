
#include <fmt/format.h>

#include "validation/case/registry.hpp"
#include "validation/case/runner.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"

namespace seiche::command {
namespace {

using validation::Case;
using validation::Job;
using validation::Tier;

/// The cases named, or all that have something to do in the tier.
std::vector<const Case*> chosen(const RunOptions& options, Tier tier) {
  std::vector<const Case*> cases;
  for (const std::string& name_of : options.cases) cases.push_back(&validation::find_case(name_of));
  if (!cases.empty()) return cases;
  if (options.tier.empty()) throw std::invalid_argument("run: name a case, or a tier with --tier");
  for (const Case& one : validation::all_cases()) {
    if (std::find(one.tiers.begin(), one.tiers.end(), tier) != one.tiers.end()) cases.push_back(&one);
  }
  return cases;
}

void print_parameters(const Case& one) {
  fmt::print("{}: {}\n{}\n\n", one.name, one.title, one.source);
  for (const validation::Parameter& p : one.parameters) {
    const auto standard = std::visit([](const auto& v) { return fmt::format("{}", v); }, p.standard.quick);
    fmt::print("  {:<18} {} [{}]\n  {:<18} default {}; {}\n", p.name, p.meaning, p.unit, "", standard, p.range());
  }
}

}  // namespace

int run(const RunOptions& options) {
  const Tier tier = tier_from(options.tier.empty() ? "quick" : options.tier);
  const std::vector<const Case*> cases = chosen(options, tier);
  if (options.help_parameters) {
    for (const Case* one : cases) print_parameters(*one);
    return 0;
  }
  std::vector<Job> jobs;
  for (const Case* one : cases) {
    jobs.push_back({one, values_for(*one, tier, options.config, options.settings)});
  }
  return exit_status(run_all(jobs, options.run));
}

}  // namespace seiche::command
