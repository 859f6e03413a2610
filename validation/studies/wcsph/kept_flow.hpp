/// Computations by weakly compressible SPH in checkpoints.
#pragma once

#include "seiche/models/wcsph/flow.hpp"
#include "validation/case/tape.hpp"

namespace seiche::validation {

inline void exchange(Tape& tape, wcsph::Particles& p) {
  tape(p.x, p.z, p.u, p.w, p.density, p.mass, p.kind, p.body, p.identity);
}
/// What is read goes on as what was written would have: the same bytes.
inline void exchange(Tape& tape, wcsph::Flow& flow) {
  wcsph::FlowState state;
  if (!tape.reading()) state = flow.state();
  tape(state.parameters, state.particles, state.reference_x, state.reference_z, state.listed, state.half_travel,
       state.time, state.steps, state.extremes);
  if (tape.reading()) flow.resume(state);
}

}  // namespace seiche::validation
