/// What happens to Serre's wave on its way: crest, and the largest defects of what should be kept.
#pragma once

#include <string>
#include <vector>

#include "reports/evidence/figure.hpp"
#include "validation/solitary_wave/serre_wave.hpp"

namespace seiche::validation {

/// One entry per step. Defects are the largest so far, relative to the wave's energy and momentum and to a cell at
/// rest.
struct SerreHistory {
  std::vector<double> time;
  std::vector<double> crest;  ///< over the amplitude
  std::vector<double> phase;  ///< crest less the exact crest [m]
  std::vector<double> energy, volume, momentum;
};

/// Follows the flow until wave.time by steps of at most tau.
SerreHistory follow(dispersive_shallow_water_1d::Flow& flow, const SerreWave& wave, double spacing, double tau);

/// A line without the entries that are exactly zero, which a logarithmic axis cannot show.
void draw_defects(evidence::Panel& panel, const std::string& label, const SerreHistory& history,
                  std::vector<double> SerreHistory::*quantity);

}  // namespace seiche::validation
