/*
The long channel with only **22 particles**, $\tau = 0.1$ s, at $t = 25$ s (figure 26 of Bogomolov, Zakharov and Zerkal,
who do not state $h_1$: 1 m here).

**What is compared.** Mean depths, bore position and width; comparison schemes on 22 cells with the same step.

**What to look at.** The Courant number is below 0.1, without effect on particles. Lax-Friedrichs spreads the dam break
over the whole channel by its viscosity $\Delta x^2/\tau$.
*/
#include "validation/case/literature.hpp"
#include "validation/dam_break/wet_dam_break.hpp"

namespace seiche::validation::cases::long_dam_break_coarse {

WetDamBreak setup() {
  return {.ratio = 0.1,
          .dam = 110,
          .length = 220,
          .times = {25},
          .atlas = {"bzz-fig-26"},
          .misses = {{"front", -12.1135}, {"width", 2}}};
}

void long_dam_break_coarse(Case& c) {
  c.title = "Dam break in a long channel by 22 particles";
  c.source = literature::bogomolov + ", figure 26";
  c.tiers = {Tier::quick};
  c.parameters = wet_dam_break_parameters(22L, 0.1);
  c.published = {{.tiles = {"bzz-fig-26"}, .stated = {"particles", "time_step", "rearrangement"}}};
  c.study = wet_dam_break<setup>();
}

}  // namespace seiche::validation::cases::long_dam_break_coarse
