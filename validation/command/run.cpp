#include <memory>
#include <thread>

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

struct Options {
  std::vector<std::string> cases;
  std::string tier;
  std::vector<std::string> settings;
  std::string config;
  bool help_parameters = false;
  validation::RunOptions run;
};

Tier tier_from(const std::string& text) {
  for (const Tier tier : {Tier::quick, Tier::full, Tier::paper}) {
    if (name(tier) == text) return tier;
  }
  throw std::invalid_argument(fmt::format("--tier {} is unknown: must be one of quick, full, paper", text));
}

/// The cases named, or all that have something to do in the tier.
std::vector<const Case*> chosen(const Options& options, Tier tier) {
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

int run(const Options& options) {
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

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  options->run.jobs = std::max(1U, std::thread::hardware_concurrency());
  CLI::App* command = app.add_subcommand("run", "Run cases and write their records");
  command->add_option("CASE", options->cases, "names of cases, see 'seiche list'");
  command->add_option("--tier", options->tier, "quick (default), full or paper; without CASE: every case of the tier");
  command->add_option("--set", options->settings, "parameter of the case, as name=value; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--config", options->config, "TOML file with parameters; tables [CASE] for single cases");
  command->add_option("--jobs,-j", options->run.jobs, "how many cases run at once")->check(CLI::Range(1U, 1024U));
  command->add_option("--out", options->run.directory, "folder for the records")->capture_default_str();
  command->add_flag("--resume", options->run.resume, "keep what an earlier run of the same program finished");
  command->add_flag("--help-parameters", options->help_parameters, "show what the cases let you set, and stop");
  command->footer("Example:\n  seiche run riemann --set right_depth=0.1 --set scheme=M2 --out evidence");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace seiche::command
