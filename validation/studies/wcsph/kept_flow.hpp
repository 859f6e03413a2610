/// Computations by weakly compressible SPH in checkpoints.
#pragma once

#include "seiche/models/wcsph/flow.hpp"
#include "validation/case/tape.hpp"

namespace seiche::validation {

void exchange(Tape& tape, wcsph::Particles& particles);
/// What is read goes on as what was written would have: the same bytes.
void exchange(Tape& tape, wcsph::Flow& flow);

}  // namespace seiche::validation
