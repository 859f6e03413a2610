/// The wet dam breaks of Bogomolov, Zakharov and Zerkal (figures 22 to 26): one set-up, five resolutions.
#pragma once

#include <fmt/format.h>

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
  std::map<std::string, double> misses;  ///< by the rearrangement as written
};

/// Parameters of every one of these cases, with the figure's resolution as standard.
std::vector<Parameter> wet_dam_break_parameters(ByTier<long> particles, ByTier<double> time_step);

void claim_wet_dam_break(const WetDamBreak& setup, const Values& values, const Claims<ParticleFigure>& claims);
ParticleFigure compute_wet_dam_break(const WetDamBreak& setup, const Run& run);

template <WetDamBreak (*setup)()>
Study wet_dam_break() {
  return Study(
      +[](const Values& values, const Claims<ParticleFigure>& claims) { claim_wet_dam_break(setup(), values, claims); },
      +[](const Run& run) { return compute_wet_dam_break(setup(), run); },
      +[](const ParticleFigure& figure, const Values& /*values*/, evidence::Exhibit& exhibit) {
        show_figure(figure, exhibit, fmt::format("Dam break over water, h0/h1 = {:g}", setup().ratio), setup().atlas);
      });
}

}  // namespace seiche::validation
