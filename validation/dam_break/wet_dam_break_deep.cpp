/*
As the dam break over shallow water, with $h_0 = 0.5\,h_1$: above the critical ratio 0.13827, so that the flow at the
dam is subcritical and the plateau extends across it. Bogomolov, Zakharov and Zerkal show steps 0, 40, 80 and 120 with
$\tau = 0.05$ s (their figure 23).

**What is compared.** Mean depths, bore position and width, with the comparison schemes on cells of the same width.

**What to look at.** The bore in one particle, and the plateau, without oscillations on either side.
*/
#include "validation/case/literature.hpp"
#include "validation/dam_break/wet_dam_break.hpp"

namespace seiche::validation::cases::wet_dam_break_deep {

WetDamBreak setup() {
  return {.ratio = 0.5, .times = {0, 2, 4, 6}, .atlas = {"bzz-fig-23"}, .misses = {{"width", 2}}};
}

void wet_dam_break_deep(Case& c) {
  c.title = "Dam break over deep water, h0/h1 = 0.5";
  c.source = literature::bogomolov + ", figure 23";
  c.parameters = wet_dam_break_parameters({50, 800, 3200}, {0.05, 0.003, 0.00075});
  c.published = {{.tiles = {"bzz-fig-23"}, .stated = {"time_step", "rearrangement"}}};
  c.study = wet_dam_break<setup>();
}

}  // namespace seiche::validation::cases::wet_dam_break_deep
