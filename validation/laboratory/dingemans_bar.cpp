/*
Regular waves of 2.857 s propagate over a submerged bar in 0.8 m of water (Delft, condition A of the bar tests). They
steepen over the bar; behind it the bound higher harmonics are released and propagate at their own celerities.

**What is compared.** Surface elevation at six gauges: wave height, amplitudes of the harmonics, and the rms difference
over three periods. The origin of time is unknown: one shift is fitted at the first gauge and used for all. The two
gauges before the bar confirm the nominal amplitude of 0.020 m before reflections arrive; wave heights and harmonics
there are shown and not scored. The case accepts external results, and the same claims score the one-dimensional
dispersive model with improved dispersion, without friction: Manning's $n$ = 0.012 of a rough bed would dissipate 1 % of
the energy over the bar.

**What to look at.** The two gauges behind the bar: the third harmonic has $kh$ = 3.6 there, which discriminates between
dispersion relations.
*/
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::dingemans_bar {

using namespace laboratory;

constexpr double period = 2.857;

const std::vector<double> gauges{3.04, 9.44, 20.04, 26.04, 30.44, 37.04};
// Of three periods in which waves and their front are steady, inside the windows that the source names.
const std::vector<double> starts{22, 26, 31, 36, 41, 45};
/// Standard deviation of the harmonics over the 6 to 11 steady cycles of the record, gauge by gauge [m].
const std::vector<std::vector<double>> scatter{{0.00048},
                                               {0.00049},
                                               {0.00038, 0.00038},
                                               {0.00020, 0.00054, 0.00014},
                                               {0.00009, 0.00045, 0.00016},
                                               {0.00012, 0.00010, 0.00031}};

Submitted compute(const Run& run, double coarsening) {
  const Flume flume{.bed_x = {-170, 11.01, 23.04, 27.04, 33.07, 90},
                    .bed_z = {-0.8, -0.8, -0.2, -0.2, -0.8, -0.8},
                    .spacing = coarsening * run.real("spacing"),
                    .tau = coarsening * run.real("spacing") / 4,
                    .gamma = gamma_of(run.text("dispersion"))};
  dispersive::Flow flow =
      regular_waves(flume, {.depth = 0.8, .amplitude = 0.02, .period = period, .from = -150, .to = 0});
  return {{"gauges", gauge_records(flow, flume, gauges, gauges, 0.05, 57)}};
}

Experiment experiment(const Values& /*values*/) {
  Series part{.table = "dingemans_1994_bar",
              .group = Column{"x", "m", "distance from the wavemaker"},
              .abscissa = {"t", "s", "time"},
              .input = 0.03,
              .input_reason =
                  "amplitudes at the end of the record at the two gauges before the bar differ by 7 %: reflection from "
                  "bar and beach",
              .clock = Clock{.group = 3.04, .range = period / 2, .window = {22, 22 + 3 * period}},
              .calibrating = {3.04, 9.44}};
  for (std::size_t k = 0; k < gauges.size(); ++k) {
    const Window window{starts[k], starts[k] + 3 * period};
    part.read({height(gauges[k], window), misfit(gauges[k], window)});
    for (std::size_t order = 1; order <= scatter[k].size(); ++order) {
      part.readings.push_back(harmonic(gauges[k], static_cast<int>(order), period, window, scatter[k][order - 1]));
    }
  }
  return {.source =
              "M. W. Dingemans, Delft Hydraulics report H1684.12 (1994); Water Wave Propagation over Uneven Bottoms, "
              "World Scientific (1997)",
          .parts = {part},
          .files = {"dingemans_1994_bar/bed.csv"},
          .compute = compute,
          .model = "dispersive shallow water, improved dispersion",
          .miss =
              "as in the same test at half the scale: the measured energy behind the bar is 20 % below that before it, "
              "and this model is energy-conserving"};
}

void dingemans_bar(Case& c) {
  set_laboratory<experiment>(c, "Regular waves over a submerged bar: the flume of Dingemans",
                             {real("spacing", 0.04, "m", {0.02, 0.2}, "of the nodes"), dispersion_parameter()});
}

}  // namespace seiche::validation::cases::dingemans_bar
