/*
Short waves over a submerged bar, case C of `luth_bar`: 1.01 s in 0.4 m of water, $kh$ = 1.7, 0.041 m high.

**Set-up.** The one-dimensional dispersive model with improved dispersion, from waves of the height measured before the
bar. Gauges read the water's surface $\zeta$, which is more than the markers' own elevation where waves are short: the
second harmonic that runs free behind the bar has $kh$ = 6.4 there.

**What is compared.** What `luth_bar` compares, over three periods.

**What to look at.** The law of the model is Airy's to 1 % at $kh$ = 1.7. At $kh$ = 6.4 its waves run an eighth too fast
and their energy half as fast again as it should: behind the bar, where two harmonics beat, it is late or early by what
that makes of the way. With `dispersion=improved`, Airy's to the fourth order of $kh$, the misfits there are one and
a half to four times as large.
*/
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/laboratory/luth_bar_experiment.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::luth_bar_short {
namespace {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  return luth_bar_experiment("C");
}

}  // namespace

void luth_bar_short(Case& c) {
  c.title = "Short waves over a submerged bar";
  c.source = luth_bar_source;
  c.parameters = {real("spacing", {0.03, 0.02, 0.02}, "m", {0.01, 0.1}, "of the markers"), dispersion_parameter()};
  set_laboratory<experiment>(c);
  c.submission = {};  // others submit to luth_bar
}

}  // namespace seiche::validation::cases::luth_bar_short
