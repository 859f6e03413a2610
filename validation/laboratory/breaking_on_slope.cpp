/*
Regular waves climb a slope of 1:34 and break (Hansen and Svendsen): 3.33 s, plunging, and 1.67 s, spilling.

**What is compared.** Wave height and mean level along the slope: the largest height, where it is, and the root mean
square difference before breaking. The case scores others.

**What to look at.** Drive the waves such that the height at the toe is as measured, 0.0406 and 0.0695 m, with a wave
of permanent form: from linear wavemakers free second harmonics beat along the flat.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source =
    "J. B. Hansen, I. A. Svendsen, Regular waves in shoaling water: experimental data, Series Paper 21, ISVA, "
    "Technical "
    "University of Denmark (1979)";

Experiment experiment(const Values& /*values*/) {
  Series heights{.name = "heights",
                 .table = "hansen_svendsen_1979_shoaling_breaking",
                 .kind = WantedTable::Kind::profile,
                 .group = Column{"case", "1", "1: 3.33 s, 2: 1.67 s"},
                 .abscissa = {"x", "m", "distance from the toe of the slope"},
                 .quantity = {"H", "m", "wave height"},
                 .input = 0.02,
                 .input_reason = "height at the toe, standard deviation of eight points",
                 .telling = 1.5,
                 .readings = {}};
  Series levels = heights;
  levels.name = "levels";
  levels.quantity = {"level", "m", "mean level"};
  levels.input = 0.04;  // a set-down goes with the square of the height
  levels.alike = 1;
  levels.alike_reason = "both waves set the water down alike, to 0.1 mm";
  levels.input_reason = "twice that of the height, to whose square it is proportional";
  for (const double wave : {1, 2}) {
    const double breaking = wave == 1 ? 9.15 : 8.22;
    heights.readings.push_back(highest(wave, {}));
    heights.readings.push_back(when_highest(wave, {}, Kind::place));
    heights.readings.push_back(misfit(wave, {0, breaking}));
    levels.readings.push_back(misfit(wave, {0, breaking}));
  }
  return {.source = source, .parts = {heights, levels}, .files = {"hansen_svendsen_1979_shoaling_breaking/bed.csv"}};
}

}  // namespace

Case breaking_on_slope() {
  Case c;
  c.title = "Regular waves shoal and break on a slope";
  c.source = source;
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
