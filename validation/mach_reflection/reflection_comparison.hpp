/// Claims that reflections are those of an independent implementation of the same model on lattices of the same
/// spacing.
#pragma once

#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/mach_reflection/reflection_reference.hpp"
#include "validation/mach_reflection/reflection_sweep.hpp"

namespace seiche::validation {

/// Amplitudes and angles of all known reflections of the series; ids "a_w-0_3", "a_r-", "psi_r-", "stem-".
void claim_independent(evidence::Record& record, const ReflectionSeries& series,
                       const std::vector<KnownReflection>& known);
/// a_w as time goes on, next to resonance; ids "history-0_3".
void claim_independent_histories(evidence::Record& record, const std::vector<ReflectionSeries>& all);

}  // namespace seiche::validation
