#pragma once

#include "seiche/exact/reference_solution.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

/// Mass and momentum across a hydraulic jump of velocity `speed` [m/s], seen by an observer who moves with it.
/// @param name     which jump, for the identities' names
/// @param largest  velocity [m/s] that those on both sides were computed from, whose rounding they carry
SelfTest jump_identities(const std::string& name, double gravity, shallow_water::State left, shallow_water::State right,
                         double speed, double largest = 0);

}  // namespace seiche::exact
