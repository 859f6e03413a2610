/*
A dam at $x = 20$ m separates still water of depths $h_1 = 1$ m and $h_0 = 0.1\,h_1$. After its removal a rarefaction
runs upstream and a bore downstream, with a plateau of depth $h_*$ between them. For depth ratios below 0.13827, as
here, the flow at the dam is critical and independent of the downstream depth.

Bogomolov, Zakharov and Zerkal show steps 0, 40, 80 and 120 with $\tau = 0.05$ s (their figure 22; its caption prints
"0.3" for 0). They do not state the number of particles, the channel and $h_1$; $\Delta x = 1$ m on $[0, 50]$ m and 1 m
are taken here.

**What is compared.** Mean depths, bore position and width, with the comparison schemes on cells of the same width.

**What to look at.** The bore stays in one particle. The remaining error lies at the corners of the rarefaction, where
particles have expanded to 2.5 times their initial width, and in the bore position, which lags by a quarter of a cell
from the start. The rearrangement as written has a plateau 5 % too low.
*/
#include "validation/case/literature.hpp"
#include "validation/dam_break/wet_dam_break.hpp"

namespace seiche::validation::cases::wet_dam_break_shallow {

WetDamBreak setup() {
  return {.ratio = 0.1, .times = {0, 2, 4, 6}, .atlas = {"bzz-fig-22"}, .misses = {{"width", 21}}};
}

void wet_dam_break_shallow(Case& c) {
  c.title = "Dam break over shallow water, h0/h1 = 0.1";
  c.source = literature::bogomolov + ", figure 22";
  c.parameters = wet_dam_break_parameters({50, 800, 3200}, {0.05, 0.003, 0.00075});
  c.published = {{.tiles = {"bzz-fig-22"}, .stated = {"time_step", "rearrangement"}}};
  c.study = wet_dam_break<setup>();
}

}  // namespace seiche::validation::cases::wet_dam_break_shallow
