/*
Regular waves over a submerged bar in 0.4 m of water (Delft; the geometry of Beji and Battjes), cases A (2.02 s) and C
(1.01 s), both non-breaking.

**What is compared.** Surface elevation at ten gauges over about four seconds: wave height, first harmonics, and the rms
difference over a whole number of periods. One time shift is fitted before the bar and used for all gauges. The two
gauges before the bar set the amplitude: wave heights and harmonics there are shown and not scored. The case accepts
external results, and the same claims score the one-dimensional dispersive model with improved dispersion; for case C
see `luth_bar_short`.

**What to look at.** Case A behind the bar, where the higher harmonics propagate freely. In case C the incident wave is
short already, $kh$ = 1.7, and its second harmonic has $kh$ = 6.4, beyond the validity of any long-wave dispersion
relation.
*/
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/laboratory/luth_bar_experiment.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::luth_bar {

using namespace laboratory;

void luth_bar(Case& c) {
  set_laboratory<[](const Values& values) { return luth_bar_experiment(values.text("wave")); }>(
      c, "Regular waves over a submerged bar: the flume of Luth, Klopman and Kitou",
      {choice("wave", "A", {"A", "C"}, "the waves: 2.02 or 1.01 s"),
       real("spacing", 0.02, "m", {0.01, 0.1}, "of the nodes"), dispersion_parameter()});
}

}  // namespace seiche::validation::cases::luth_bar
