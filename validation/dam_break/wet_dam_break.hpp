/// The wet dam breaks of Bogomolov, Zakharov and Zerkal (figures 22 to 26): one set-up, five resolutions.
#pragma once

#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_run.hpp"

namespace seiche::validation {

/// What differs between the figures.
struct WetDamBreak {
  double ratio = 0.1;                              ///< h0/h1
  double dam = 20;                                 ///< [m]
  double length = 50;                              ///< [m]
  std::vector<double> times;                       ///< shown, the last is judged [s]
  std::vector<std::string> schemes = all_schemes;  ///< compared at the same resolution
  std::vector<std::string> atlas;
};

/// Parameters of every one of these cases, with the figure's resolution as standard.
std::vector<Parameter> wet_dam_break_parameters(ByTier<long> particles, ByTier<double> time_step);

/// The particles and the schemes compared.
struct WetDamBreakResults {
  FlowRun flow;
  Front front;
  std::vector<Contestant> contestants;
};

void claim_wet_dam_break(const WetDamBreak& setup, const Values& values, const Claims<WetDamBreakResults>& claims);
WetDamBreakResults compute_wet_dam_break(const WetDamBreak& setup, const Run& run);
void show_wet_dam_break(const WetDamBreak& setup, const WetDamBreakResults& r, evidence::Exhibit& exhibit);

template <WetDamBreak (*setup)()>
Study wet_dam_break() {
  return Study(
      +[](const Values& values, const Claims<WetDamBreakResults>& claims) {
        claim_wet_dam_break(setup(), values, claims);
      },
      +[](const Run& run) { return compute_wet_dam_break(setup(), run); },
      +[](const WetDamBreakResults& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
        show_wet_dam_break(setup(), r, exhibit);
      });
}

}  // namespace seiche::validation
