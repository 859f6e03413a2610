#include <algorithm>

#include <fmt/format.h>
#include <fnmatch.h>

#include "validation/case/registry.hpp"
#include "validation/case/runner.hpp"
#include "validation/command/commands.hpp"
#include "validation/command/settings.hpp"

namespace seiche::command {
namespace {

using validation::Case;
using validation::Job;
using validation::Tier;

std::vector<const Case*> named(const RunOptions& options) {
  std::vector<const Case*> cases;
  const auto add = [&](const Case& one) {
    if (std::ranges::find(cases, &one) == cases.end()) cases.push_back(&one);
  };
  for (const std::string& name_of : options.cases) {
    if (name_of.find_first_of("*?") == std::string::npos) {
      add(validation::find_case(name_of));
      continue;
    }
    const std::size_t before = cases.size();
    for (const Case& one : validation::all_cases()) {
      if (fnmatch(name_of.c_str(), one.name.c_str(), 0) == 0) add(one);
    }
    if (cases.size() == before) fail("run: no further case is called {}: 'seiche list' shows all", name_of);
  }
  return cases;
}

/// All runs of a tier. Settings are for its defaults: what the sources did is not to be changed.
std::vector<Job> jobs_of(Tier tier, const RunOptions& options) {
  const bool as_given = options.config.empty() && options.settings.empty();
  std::vector<Job> jobs;
  for (const Case& one : validation::all_cases()) {
    if (as_given) {
      for (validation::Values& values : one.runs_of(tier)) jobs.push_back({&one, std::move(values)});
    } else if (std::ranges::find(one.tiers, tier) != one.tiers.end()) {
      jobs.push_back({&one, values_for(one, tier, options.config, options.settings)});
    }
  }
  return jobs;
}

/// The tier to run a case in where none is asked for: the quick one, or the first that it has.
Tier usual_tier(const Case& one) {
  const Tier usual = one.tiers.empty() ? Tier::quick : one.tiers.front();
  if (usual != Tier::quick) fmt::print(stderr, "{} has no quick tier: runs in the tier {}\n", one.name, name(usual));
  return usual;
}

/// The one case that --as is about, with its set.
Job published_job(const std::vector<const Case*>& cases, const RunOptions& options) {
  if (cases.size() != 1)
    fail("run --as: name exactly one case; its as-published sets are listed by 'seiche list --published'");
  if (!options.config.empty()) fail("run: --as and --config: leave one of the two out");
  Job job{cases.front(), published_values(*cases.front(), options.as, options.settings)};
  if (!options.tier.empty() && tier_from(options.tier) != job.values.tier()) {
    fail("run --as: the as-published set {} belongs to the level {}, not --tier {}", options.as,
         name(job.values.tier()), options.tier);
  }
  return job;
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
  const std::vector<const Case*> cases = named(options);
  if (options.help_parameters) {
    for (const Case* one : cases) print_parameters(*one);
    return 0;
  }
  std::vector<Job> jobs;
  if (!options.as.empty()) {
    jobs.push_back(published_job(cases, options));
  } else if (!cases.empty()) {
    for (const Case* one : cases) {
      const Tier of_case = options.tier.empty() ? usual_tier(*one) : tier;
      jobs.push_back({one, values_for(*one, of_case, options.config, options.settings)});
    }
  } else if (!options.tier.empty()) {
    jobs = jobs_of(tier, options);
  } else {
    fail("run: name a case, or a tier with --tier");
  }
  return exit_status(run_all(jobs, options.run));
}

}  // namespace seiche::command
