#include "validation/studies/wcsph/kept_flow.hpp"

#include "seiche/models/wcsph/flow.hpp"

namespace seiche::validation {

void exchange(Tape& tape, wcsph::Particles& p) {
  tape(p.x, p.z, p.u, p.w, p.density, p.mass, p.kind, p.body, p.identity);
}

void exchange(Tape& tape, wcsph::Flow& flow) {
  wcsph::FlowState state;
  if (!tape.reading()) state = flow.state();
  tape(state.parameters, state.particles, state.reference_x, state.reference_z, state.listed, state.half_travel,
       state.time, state.steps, state.extremes);
  if (tape.reading()) flow.resume(state);
}

}  // namespace seiche::validation
