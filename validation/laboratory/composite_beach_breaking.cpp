/*
Wave C of the composite beach (`composite_beach`), a solitary wave of H/h = 0.68 that breaks on the slope and runs up
the wall as a bore.

**Set-up.** The one-dimensional dispersive model from a solitary wave of the height measured at gauge 4. Fronts begin to
break at a slope of 30 degrees and stop at a Froude number of 1.3, with the viscosity that leaves no waves behind a
bore; the friction coefficient is the value for glass. No parameter is fitted to the experiment.

**What is compared.** As in `composite_beach`: elevation at seven gauges and the run-up on the wall.

**What to look at.** Gauges 8 to 10, which the bore passes twice. Without breaking the run ends when the wave reaches
the wall and leaves it dry.
*/
#include "validation/laboratory/composite_beach_experiment.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::composite_beach_breaking {

using namespace laboratory;

void composite_beach_breaking(Case& c) {
  set_laboratory<[](const Values&) { return composite_beach_experiment("C"); }>(
      c, "Breaking of a solitary wave on a beach of three slopes",
      {real("spacing", 0.02, "m", {0.005, 0.1}, "of the nodes")});
  c.submission = {};  // others submit to composite_beach
}

}  // namespace seiche::validation::cases::composite_beach_breaking
