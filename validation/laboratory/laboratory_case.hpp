/// A laboratory experiment as a case: see experiment.hpp.
///
///     Experiment experiment(const Values&) { return {.source = source, .parts = {...}}; }
///
///     void submerged_bar(Case& c) {
///       c.title = "...";
///       set_laboratory<experiment>(c);
///     }
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

/// Study and submission of a case.
template <Experiment (*describe)(const Values&)>
void set_laboratory(Case& c) {
  void (*declare)(const Values&, const Claims<Computed>&) = [](const Values& values, const Claims<Computed>& claims) {
    claim_experiment(describe(values), values, claims);
  };
  Computed (*compute)(const Run&) = [](const Run& run) { return compute_experiment(describe(run), run); };
  void (*show)(const Computed&, const Values&, evidence::Exhibit&) = [](const Computed& computed, const Values& values,
                                                                        evidence::Exhibit& exhibit) {
    show_experiment(describe(values), computed, values, exhibit);
  };
  c.study = Study(declare, compute, show);
  c.submission = {.tables = [](const Values& values) { return wanted(describe(values), values); },
                  .judge = [](const Values& values, const Submitted& submitted, const SolverFacts& facts,
                              evidence::Record& record) { judge(describe(values), values, submitted, facts, record); }};
}

}  // namespace seiche::validation::laboratory
