/// What a run of the dispersive shallow-water model did not keep.
#pragma once

#include <functional>

#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"

namespace seiche::verification {

/// Largest defects over a run.
struct Defects {
  double energy = 0;        ///< over the energy of the start
  double momentum = 0;      ///< over the momentum of the start
  double volume = 0;        ///< of the worst cell [m^2]
  double total_volume = 0;  ///< [m^2]
  double solves = 0;        ///< per step
  long steps = 0;
};

/// Runs to `end` with steps of at most tau and `courant` times the longest stable one; `after_step` is called after
/// each.
inline Defects defects_until(dispersive_shallow_water_1d::Flow& flow, double end, double tau, double courant = 0.3,
                             const std::function<void()>& after_step = {}) {
  const double energy = flow.energy();
  const long solves = flow.solves();
  march(flow, end, stable_steps(flow, tau, courant), [&] {
    flow.observe();
    if (after_step) after_step();
  });
  const mechanics::InvariantsLedger& ledger = flow.ledger();
  return {.energy = ledger.largest_defect("energy") / energy,
          .momentum = ledger.largest_defect("momentum") / ledger.entry("momentum_x").initial,
          .volume = ledger.largest_defect("volume_worst"),
          .total_volume = ledger.largest_defect("volume_total"),
          .solves = static_cast<double>(flow.solves() - solves) / static_cast<double>(flow.steps()),
          .steps = flow.steps()};
}

}  // namespace seiche::verification
