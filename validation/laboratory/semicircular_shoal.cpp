/*
A semicircular shoal focuses regular waves in a tank (Whalin 1971): periods of 1, 2 and 3 s.

**What is compared.** Amplitudes of the harmonics of the elevation along the centre line: maximum, its position, and the
rms difference from 5 to 23 m. The case accepts external results, and the same claims score the 2DH model with improved
dispersion: half of the tank, a paddle at x = 0, and an absorbing layer beyond 25 m.

**What to look at.** The amplitude of the incident wave is itself uncertain by 10 %: the first harmonic before the shoal
is 14 % above, 6 % below and 10 % above the nominal one. The second harmonic of 3 s still grows at the last measured
point; the position of its maximum is not scored. Waves of 1 s, $kh$ = 1.9, need accurate linear dispersion.
*/
#include <algorithm>
#include <cmath>

#include "validation/laboratory/laboratory_case.hpp"
#include "validation/studies/dispersive_shallow_water/wave_basin.hpp"

namespace seiche::validation::cases::semicircular_shoal {

using namespace laboratory;

constexpr double half_width = 3.048;  // of the tank [m]

/// A set of waves of the experiment, and how long they take to be the same from one period to the next.
struct Train {
  double amplitude;  ///< [m]
  double settled;    ///< [s]
  long periods;      ///< from then on that are judged
};

Train train_of(long period) {
  if (period == 1) return {0.0195, 34, 3};
  if (period == 2) return {0.0075, 28, 2};
  return {0.0068, 30, 2};
}

double bottom(double x, double y) {
  const double from_axis = std::min(std::abs(y), half_width - 0.15);  // beside the walls the edge is infinitely steep
  const double edge = 10.67 - std::sqrt(half_width * half_width - from_axis * from_axis);
  return -0.4572 + std::clamp((x - edge) / 25, 0.0, 0.3048);
}

/// Half of the tank: its axis is a line of symmetry.
Submitted compute(const Run& run, double coarsening) {
  const long period = run.integer("period");
  const double spacing = coarsening * run.real("spacing");
  const auto [amplitude, settled, periods] = train_of(period);
  auto flow = basin_flow({.begin = 0,
                          .end = 31,
                          .north = half_width,
                          .bottom = bottom,
                          .raster = 0.1016,
                          .spacing = spacing,
                          .absorbed_from = 25},
                         {.depth = 0.4572, .amplitude = amplitude, .period = static_cast<double>(period)});
  const long steps = std::lround(4 * static_cast<double>(period) / spacing);
  const auto length = static_cast<double>(period);
  march(flow, std::ceil(settled / length) * length, length / static_cast<double>(steps));
  std::vector<Point> places;
  std::vector<double> abscissa;
  for (double k = 0; k <= 190; ++k) {
    abscissa.push_back(4.5 + 0.1 * k);
    places.push_back({abscissa.back(), 0});
  }
  const auto amplitudes = harmonics_at(flow, places, period == 1 ? 2 : 3, length, steps, periods);
  std::vector<SubmittedGroup> groups;
  for (std::size_t order = 0; order < amplitudes.size(); ++order) {
    groups.push_back(
        {.value = static_cast<double>(order + 1), .abscissa = abscissa, .values = {{"a", amplitudes[order]}}});
  }
  return {{"harmonics", groups}};
}

Experiment experiment(const Values& values) {
  const auto period = values.number("period");
  Series part{.name = "harmonics",
              .table = "whalin_1971_semicircular_shoal",
              .kind = WantedTable::Kind::profile,
              .group = Column{"harmonic", "1", "order"},
              .abscissa = {"x", "m", "distance from the wavemaker on the centre line"},
              .quantity = {"a", "m", "amplitude of the harmonic"},
              .rows = {{"period", period}},
              .spread = "u",
              .input = 0.1,
              .input_reason = "the first harmonic before the shoal against the nominal amplitude: +14, -6 and +10 %",
              .telling = half_width};
  const Window window{5, 23};
  for (double harmonic = 1; harmonic <= (period == 1 ? 2 : 3); ++harmonic) {
    part.readings.push_back(highest(harmonic, window));
    if (period < 3 || harmonic != 2) part.readings.push_back(when_highest(harmonic, window, Kind::place));
    part.readings.push_back(misfit(harmonic, window));
  }
  return {.source =
              "R. W. Whalin, The limit of applicability of linear wave refraction theory in a convergence zone, "
              "Research Report H-71-3, US Army Engineer Waterways Experiment Station, Vicksburg (1971)",
          .parts = {part},
          .files = {"whalin_1971_semicircular_shoal/bathymetry.asc"},
          .ceiling = 0.3,
          .ceiling_reason = "uncertainty of the incident amplitude, 10 %, as stated in the title",
          .compute = values.tier() == Tier::quick ? nullptr : compute,
          .model = basin_model,
          .coarsenings = {1, 1.5, 2}};
}

void semicircular_shoal(Case& c) {
  set_laboratory<experiment>(c, "Regular waves on a semicircular shoal, incident amplitude known to 10 %",
                             {integer("period", {2, 1, 3}, {1, 3}, "of the waves [s]"),
                              real("spacing", 0.06, "m", {0.05, 0.15}, "column width, for the model run")});
}

}  // namespace seiche::validation::cases::semicircular_shoal
