/// The wet dam breaks of Bogomolov, Zakharov and Zerkal (figures 22 to 26): one set-up, five resolutions.
#pragma once

#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation {

/// What differs between the figures.
struct WetDamBreak {
  double ratio = 0.1;                              ///< h0/h1
  double dam = 20;                                 ///< [m]
  double length = 50;                              ///< [m]
  std::vector<double> times;                       ///< shown, the last is judged [s]
  std::vector<std::string> schemes = all_schemes;  ///< compared at the same resolution
  std::vector<std::string> atlas;
  double cell_l1_h = 0;  ///< of H2 with the standard parameters, known from an independent implementation [m]
};

/// Parameters of every one of these cases, with the figure's resolution as standard.
std::vector<Parameter> wet_dam_break_parameters(ByTier<long> particles, ByTier<double> time_step);

/// Runs it and fills the record.
void run_wet_dam_break(Running& run, const WetDamBreak& setup);

}  // namespace seiche::validation
