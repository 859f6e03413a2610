/*
A longer channel: dam at $x = 100$ m in $[0, 200]$ m, $h_0/h_1 = 0.1$, 200 particles, $\tau = 0.05$ s, shown at $t =
25.3$ s, after 506 steps (figure 25 of Bogomolov, Zakharov and Zerkal, who do not state $h_1$: 1 m here).

**What is compared.** Mean depths, bore position and width, beside the other variants of the method.

**What to look at.** After 78 m the bore still occupies one particle and lags by a third of a metre.
*/
#include "validation/case/literature.hpp"
#include "validation/dam_break/wet_dam_break.hpp"

namespace seiche::validation::cases::long_dam_break_fine {

WetDamBreak setup() {
  return {.ratio = 0.1,
          .dam = 100,
          .length = 200,
          .times = {25.3},
          .schemes = particle_schemes,
          .atlas = {"bzz-fig-25"},
          .misses = {{"cell_l1_h", 0.0139586}, {"front", 3.7177}, {"width", 89}}};
}

void long_dam_break_fine(Case& c) {
  c.title = "Dam break in a long channel by 200 particles";
  c.source = literature::bogomolov + ", figure 25";
  c.tiers = {Tier::quick};
  c.parameters = wet_dam_break_parameters(200L, 0.05);
  c.published = {{.tiles = {"bzz-fig-25"}, .stated = {"particles", "time_step", "rearrangement"}}};
  c.study = wet_dam_break<setup>();
}

}  // namespace seiche::validation::cases::long_dam_break_fine
