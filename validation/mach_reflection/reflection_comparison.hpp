/// Claims that reflections are those of an earlier program for the same model on lattices of the same spacing, which
/// ran until the stem should have settled.
#pragma once

#include <vector>

#include "validation/case/claims.hpp"
#include "validation/mach_reflection/reflection_reference.hpp"
#include "validation/mach_reflection/reflection_sweep.hpp"

namespace seiche::validation {

/// Amplitudes and angles of all known reflections of the series; ids "a_w-0_3", "a_r-", "psi_r-", "stem-".
/// @param series  to be run
void claim_known_reflections(const Claims<ReflectionSeries>& claims, const ReflectionSeries& series,
                             const std::vector<KnownReflection>& known);
/// a_w as time goes on, next to resonance, where it is known of an angle of the series; ids "history-0_3".
void claim_known_history(const Claims<ReflectionSeries>& claims, const ReflectionSeries& series, const Values& values);

}  // namespace seiche::validation
