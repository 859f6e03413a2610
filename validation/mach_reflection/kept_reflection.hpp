/// Reflections in checkpoints: a run of a case that meets many takes those that an interrupted one had finished.
#pragma once

#include "validation/case/study.hpp"
#include "validation/mach_reflection/reflection_run.hpp"

namespace seiche::validation {

void exchange(Tape& tape, Measurement& measurement);
void exchange(Tape& tape, Reflection& reflection);

/// reflect(what), a part of the run.
Reflection reflect_as_part(const Run& run, const ReflectionRun& what);

}  // namespace seiche::validation
