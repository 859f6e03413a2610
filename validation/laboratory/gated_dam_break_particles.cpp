/*
A dam breaks over water behind a gate (`gated_dam_break`), by the conservative particles of shallow water of Bogomolov,
Zakharov and Zerkal.

**Set-up.** Particles as wide as the parameter `cell` at the beginning, everywhere; the hand-over between neighbours of
second order (H2). No gate: it is gone at once.

**What is compared.** What `gated_dam_break` compares: the place of the front, on one fitted clock.

**What to look at.** The same equations as there, so the same front to a millimetre: what both miss is not the scheme's.
*/
#include "validation/laboratory/gated_dam_break_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::gated_dam_break_particles {
namespace {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  return gated_dam_break_in_shallow_water("H2", "shallow-water particles");
}

}  // namespace

void gated_dam_break_particles(Case& c) {
  c.title = "A dam breaks over water behind a gate: shallow-water particles";
  c.source = gated_dam_break_source;
  c.parameters = {real("cell", 0.005, "m", {0.0005, 0.02}, "width of a particle at the beginning")};
  set_laboratory<experiment>(c);
  c.submission = {};  // others submit to gated_dam_break
}

}  // namespace seiche::validation::cases::gated_dam_break_particles
