/*
Regular waves are focused by a semicircular shoal in a tank (Whalin): periods of 1, 2 and 3 s.

**What is compared.** Amplitudes of the harmonics of the elevation along the centre line: the largest, where it is,
and the root mean square difference from 5 to 23 m. The case scores others.

**What to look at.** The amplitude of the incident wave is itself uncertain by a tenth: the first harmonic before the
shoal is 14 % above, 6 % below and 10 % above the nominal one. The third harmonic of 2 s is not known well enough to
be judged. Waves of 1 s need good linear dispersion, $kh$ = 1.9.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source =
    "R. W. Whalin, The limit of applicability of linear wave refraction theory in a convergence zone, Research Report "
    "H-71-3, US Army Engineer Waterways Experiment Station, Vicksburg (1971)";

Experiment experiment(const Values& values) {
  const double period = static_cast<double>(values.integer("period"));
  Series part{.name = "harmonics",
              .table = "whalin_1971_semicircular_shoal",
              .kind = WantedTable::Kind::profile,
              .group = Column{"harmonic", "1", "order"},
              .abscissa = {"x", "m", "distance from the wavemaker on the centre line"},
              .quantity = {"a", "m", "amplitude of the harmonic"},
              .rows = {{"period", period}},
              .input = 0.1,
              .input_reason = "the first harmonic before the shoal against the nominal amplitude: +14, -6 and +10 %",
              .telling = 8,
              .readings = {}};
  const Window window{5, 23};
  for (double harmonic = 1; harmonic <= (period == 3 ? 3 : 2); ++harmonic) {
    part.readings.push_back(highest(harmonic, window));
    part.readings.push_back(when_highest(harmonic, window, Kind::place));
    part.readings.push_back(misfit(harmonic, window));
  }
  return {.source = source, .parts = {part}, .files = {"whalin_1971_semicircular_shoal/bathymetry.asc"}};
}

}  // namespace

Case semicircular_shoal() {
  Case c;
  c.title = "Regular waves on a semicircular shoal";
  c.source = source;
  c.parameters = {integer("period", 2, {1, 3}, "of the waves [s]")};
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
