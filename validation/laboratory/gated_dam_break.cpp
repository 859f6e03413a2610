/*
A dam of 0.15 m breaks over 0.038 m of water (Janosi and others). The water behind the gate pushes a jet up that
overturns.

**What is compared.** The place of the front, where the surface first exceeds 0.055 m. One shift of time is fitted to
the first four of the eight frames and reported: a gate that takes 0.1 s to clear the water delays the front. The other
four are compared. The case scores others, and
shallow water with a second-order finite-volume scheme is scored by the same claims; by particles of shallow water in
`gated_dam_break_particles`, by weakly compressible SPH in `gated_dam_break_sph`.

**What to look at.** The front's speed. The level ahead is read off by up to 7 mm: heights are not asked for.
*/
#include "validation/laboratory/gated_dam_break_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::gated_dam_break {
namespace {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  return gated_dam_break_in_shallow_water("muscl", "shallow water, finite volumes");
}

}  // namespace

void gated_dam_break(Case& c) {
  c.title = "A dam breaks over water behind a gate";
  c.source = gated_dam_break_source;
  c.parameters = {real("cell", 0.005, "m", {0.0005, 0.02}, "size")};
  set_laboratory<experiment>(c);
}

}  // namespace seiche::validation::cases::gated_dam_break
