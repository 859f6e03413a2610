/*
A solitary wave climbs a beach of three slopes, 1:53, 1:150 and 1:13, before a vertical wall: the model of Revere Beach
(NTHMP benchmark problem 5). Wave A, H/h = 0.038, does not break; B (0.26) breaks at the wall, C (0.68) on the slope.

**What is compared.** Surface elevation at seven gauges, up to the wave reflected by the wall: maximum, time of reaching
half of the incident height, and rms difference; the maximum run-up on the wall. Levels before arrival are removed. One
time shift is fitted at gauge 4, which records the incident wave and sets the input; gauge 4 is shown and not scored.
All computations include the friction of a glass flume. The case accepts external results; for wave A the same claims
score the one-dimensional dispersive model, from a solitary wave of the height measured at gauge 4; for wave C, with
breaking, see `composite_beach_breaking`.

**What to look at.** The stated heights are 2 to 3 % above the recorded ones. Gauge 4 has a different position for each
wave. The run-up of B is a jet at the wall, and C breaks: models without breaking cannot reproduce them.
*/
#include "validation/laboratory/composite_beach_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::composite_beach {

using namespace laboratory;

void composite_beach(Case& c) {
  set_laboratory<[](const Values& values) { return composite_beach_experiment(values.text("wave")); }>(
      c, "A solitary wave on a beach of three slopes before a wall",
      {choice("wave", "A", {"A", "B", "C"}, "the wave: H/h = 0.038 (A), 0.26 (B) or 0.68 (C)"),
       real("spacing", 0.02, "m", {0.005, 0.1}, "of the nodes")});
}

}  // namespace seiche::validation::cases::composite_beach
