/*
A solitary wave climbs a beach of three slopes, 1:53, 1:150 and 1:13, before a vertical wall: the model of Revere
Beach (NTHMP benchmark problem 5). Wave A, 0.038 depths high, does not break; B (0.26) breaks at the wall, C (0.68) on
the slope.

**What is compared.** Surface elevation at seven gauges, as far as the wave that comes back from the wall: highest
value, when it reaches half of the incident height, and the root mean square difference; the maximum run-up on the wall.
The levels before arrival are removed. One shift of time is fitted at gauge 4, where the wave comes in and whose height
sets the input: it is shown and not scored. The flume is of glass, with its friction in all computations. The case
scores others; for wave A the one-dimensional dispersive model is scored by the same claims, from a solitary wave as
high as gauge 4 measured it; for wave C, with breaking, in `composite_beach_breaking`.

**What to look at.** The stated heights are 2 to 3 % above the recorded ones. Gauge 4 stands at another place for
each wave. The run-up of B is a jet at the wall, and C breaks: no model without breaking need reach them.
*/
#include "validation/laboratory/composite_beach_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::composite_beach {
namespace {

using namespace laboratory;

Experiment experiment(const Values& values) {
  return composite_beach_experiment(values.text("wave"));
}

}  // namespace

void composite_beach(Case& c) {
  c.title = "A solitary wave on a beach of three slopes before a wall";
  c.source = composite_beach_source;
  c.parameters = {choice("wave", "A", {"A", "B", "C"}, "the wave: 0.038, 0.26 or 0.68 depths high"),
                  real("spacing", 0.02, "m", {0.005, 0.1}, "of the markers")};
  set_laboratory<experiment>(c);
}

}  // namespace seiche::validation::cases::composite_beach
