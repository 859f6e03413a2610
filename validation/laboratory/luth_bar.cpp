/*
Regular waves over a submerged bar in 0.4 m of water (Delft; the geometry of Beji and Battjes), cases A (2.02 s) and C
(1.01 s), neither of which breaks.

**What is compared.** Surface elevation at ten gauges over about four seconds: height, first harmonics, and the root
mean square difference over a whole number of periods. One shift of time is fitted before the bar and used for all
gauges. The two gauges before the bar set the amplitude: heights and harmonics there are shown and not scored. The case
scores others, and the one-dimensional dispersive model with improved dispersion is scored by the same claims; with case
C in `luth_bar_short`.

**What to look at.** Case A behind the bar, where the higher harmonics run free. In case C already the wave before the
bar is a short one, $kh$ = 1.7, and its second harmonic has $kh$ = 6.4, beyond any law of long waves.
*/
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/laboratory/luth_bar_experiment.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::luth_bar {
namespace {

using namespace laboratory;

Experiment experiment(const Values& values) {
  return luth_bar_experiment(values.text("wave"));
}

}  // namespace

void luth_bar(Case& c) {
  c.title = "Regular waves over a submerged bar: the flume of Luth, Klopman and Kitou";
  c.source = luth_bar_source;
  c.parameters = {choice("wave", "A", {"A", "C"}, "the waves: 2.02 or 1.01 s"),
                  real("spacing", 0.02, "m", {0.01, 0.1}, "of the markers"), dispersion_parameter()};
  set_laboratory<experiment>(c);
}

}  // namespace seiche::validation::cases::luth_bar
