/// The plan model against a manufactured motion of a basin (manufactured/plan_manufactured.hpp).
#pragma once

#include <cstddef>

#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "validation/instruments/manufactured/plan_manufactured.hpp"

namespace seiche::validation {

struct PlanManufacturedRun {
  std::size_t n = 16;       ///< cells along each side of the basin
  long steps_per_cell = 4;  ///< tau is the width of a cell over this, changed to fit the time
  double time = 2;
  dispersive_shallow_water_2d::Scheme scheme = {};
  PlanManufactured::Parameters motion = {};

  /// Steps in all.
  [[nodiscard]] long steps() const;
};

/// At the end, L2 norms over the labels, (integral of squares)^(1/2), by the trapezoidal rule on the nodes.
struct PlanManufacturedErrors {
  double position = 0;  ///< in plan
  double elevation = 0;
  double velocity = 0;  ///< horizontal
};

/// Nodes with equally spaced labels, exact velocities made to keep the volumes.
dispersive_shallow_water_2d::Flow plan_manufactured_flow(const PlanManufacturedRun& run);
PlanManufacturedErrors plan_manufactured_errors(const PlanManufacturedRun& run);
/// The same against another flow of the same nodes, instead of the exact motion.
PlanManufacturedErrors differences(const dispersive_shallow_water_2d::Flow& flow,
                                   const dispersive_shallow_water_2d::Flow& other);

}  // namespace seiche::validation
