/*
A dam break over water behind a gate (`gated_dam_break`), computed with the conservative shallow-water particles of
Bogomolov, Zakharov and Zerkal.

**Set-up.** Particles of uniform initial width, the parameter `cell`; second-order hand-over between neighbours (H2).
The gate vanishes at t = 0.

**What is compared.** As in `gated_dam_break`: the front position, with one fitted time origin.

**What to look at.** The equations are the same as in `gated_dam_break`, and so is the front, to a millimetre: the
common error comes from the equations, not from the schemes.
*/
#include "validation/laboratory/gated_dam_break_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::gated_dam_break_particles {

using namespace laboratory;

void gated_dam_break_particles(Case& c) {
  set_laboratory<[](const Values&) { return gated_dam_break_in_shallow_water("H2", "shallow-water particles"); }>(
      c, "Dam break over water behind a gate: shallow-water particles",
      {real("cell", 0.005, "m", {0.0005, 0.02}, "initial particle width")});
  c.submission = {};  // others submit to gated_dam_break
}

}  // namespace seiche::validation::cases::gated_dam_break_particles
