/*
Short waves over a submerged bar, case C of `luth_bar`: period 1.01 s in 0.4 m of water, $kh$ = 1.7, height 0.041 m.

**Set-up.** The one-dimensional dispersive model with improved dispersion, from waves of the height measured before the
bar. Gauges read the free surface $\zeta$, which exceeds the elevation of the model's nodes for short waves: the free
second harmonic behind the bar has $kh$ = 6.4.

**What is compared.** As in `luth_bar`, over three periods.

**What to look at.** The celerity of the model agrees with Airy's within 1 % at $kh$ = 1.7. At $kh$ = 6.4 its celerity
is an eighth too high and its group velocity half as large again as it should be: behind the bar, where two harmonics
beat, the phase error grows with the distance. With `dispersion=improved`, Airy's relation to fourth order in $kh$, the
misfits there are 1.5 to 4 times as large.
*/
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/laboratory/luth_bar_experiment.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::luth_bar_short {

using namespace laboratory;

void luth_bar_short(Case& c) {
  set_laboratory<[](const Values&) { return luth_bar_experiment("C"); }>(
      c, "Short waves over a submerged bar",
      {real("spacing", {0.03, 0.02, 0.02}, "m", {0.01, 0.1}, "of the nodes"), dispersion_parameter()});
  c.submission = {};  // others submit to luth_bar
}

}  // namespace seiche::validation::cases::luth_bar_short
