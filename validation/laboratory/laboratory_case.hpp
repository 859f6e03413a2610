/// A laboratory experiment as a case: see experiment.hpp.
///
///     Experiment experiment(const Values&) { return {.source = "...", .parts = {...}}; }
///
///     void submerged_bar(Case& c) { set_laboratory<experiment>(c, "Waves over a submerged bar"); }
#pragma once

#include "validation/laboratory/verdicts.hpp"

namespace seiche::validation::laboratory {

struct Computed {
  double noticed = 0;            ///< smallest common factor, less 1, that the measurements tell
  double failing = 0;            ///< share of records, each the measured one with noise as large as stated, that fail
  std::vector<Submitted> grids;  ///< of our own model, the finest first, on the measured clock; empty without one
  std::map<std::string, double> shifts;
};

void claim_experiment(const Experiment& experiment, const Values& values, const Claims<Computed>& claims);
Computed compute_experiment(const Experiment& experiment, const Run& run);
void show_experiment(const Experiment& experiment, const Computed& computed, const Values& values,
                     evidence::Exhibit& exhibit);

/// Title, source, parameters, study and submission of a case.
/// @tparam describe  Experiment (const Values&)
template <auto describe>
void set_laboratory(Case& c, const std::string& title, std::vector<Parameter> parameters = {}) {
  c.title = title;
  c.parameters = std::move(parameters);
  c.source = describe(c.values(Tier::quick)).source;
  c.study = Study(
      +[](const Values& values, const Claims<Computed>& claims) { claim_experiment(describe(values), values, claims); },
      +[](const Run& run) { return compute_experiment(describe(run), run); },
      +[](const Computed& computed, const Values& values, evidence::Exhibit& exhibit) {
        show_experiment(describe(values), computed, values, exhibit);
      });
  c.submission = {.tables = [](const Values& values) { return wanted(describe(values), values); },
                  .judge = [](const Values& values, const Submitted& submitted, const SolverFacts& facts,
                              evidence::Record& record) { judge(describe(values), values, submitted, facts, record); }};
}

}  // namespace seiche::validation::laboratory
