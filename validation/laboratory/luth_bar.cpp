/*
Regular waves over a submerged bar in 0.4 m of water (Delft; the geometry of Beji and Battjes), cases A (2.02 s) and C
(1.01 s), neither of which breaks.

**What is compared.** Surface elevation at ten gauges over about four seconds: height, first harmonics, and the root
mean square difference over a whole number of periods. One shift of time is fitted before the bar and used for all
gauges. The case scores others, and the one-dimensional dispersive model with improved dispersion is judged by the
same claims.

**What to look at.** Case A behind the bar, where the higher harmonics run free. In case C already the wave before the
bar is a short one, $kh$ = 1.7, and its second harmonic has $kh$ = 6.4, beyond any law of long waves.
*/
#include "validation/laboratory/dispersive_flume.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source =
    "H. R. Luth, G. Klopman, N. Kitou, Delft Hydraulics report H1573 (1994); S. Beji, J. A. Battjes, Coastal Eng. 19 "
    "(1993) 151-162";
const std::vector<double> gauges{2, 4, 10.5, 12.5, 13.5, 14.5, 15.7, 17.3, 19, 21};

bool is_long(const Values& values) {
  return values.text("wave") == "A";
}

double period_of(const Values& values) {
  return is_long(values) ? 2.02 : 1.01;
}

Submitted compute(const Run& run, double coarsening) {
  const double spacing = coarsening * run.real("spacing");
  const Flume flume{.bed_x = {-90, 6, 12, 14, 17, 60},
                    .bed_z = {-0.4, -0.4, -0.1, -0.1, -0.4, -0.4},
                    .spacing = spacing,
                    .tau = spacing / 3,
                    .gamma = gamma_of(run.text("dispersion"))};
  dispersive::Flow flow =
      regular_waves(flume, {.depth = 0.4, .amplitude = 0.0108, .period = period_of(run), .from = -80, .to = 0});
  const double steady = 28;  // when the slowest harmonics have come to the last gauge
  flow.advance_to(steady - 2, flume.tau);
  return {{"gauges", gauge_records(flow, flume, gauges, gauges, 0.02, steady + 7, steady)}};
}

/// At the standard parameters; a band is a half more than what twice the spacing changes, or an eighth.
std::map<std::string, evidence::KnownFailure> misses() {
  const std::string why =
      "as in the same test at twice the scale: too little of the energy goes to harmonics of k h above 3 over the bar, "
      "the first stays 15 to 25 % too high, and nothing dissipates";
  return {
      {"gauges-height-12_5", {.value = 0.0364, .width = 0.00052, .reason = why}},
      {"gauges-misfit-12_5", {.value = 0.00238, .width = 0.00029, .reason = why}},
      {"gauges-misfit-13_5", {.value = 0.00304, .width = 0.00037, .reason = why}},
      {"gauges-height-14_5", {.value = 0.0373, .width = 0.00063, .reason = why}},
      {"gauges-misfit-14_5", {.value = 0.0052, .width = 0.00066, .reason = why}},
      {"gauges-misfit-15_7", {.value = 0.00302, .width = 0.00077, .reason = why}},
      {"gauges-harmonic-1-15_7", {.value = 0.00722, .width = 0.00018, .reason = why}},
      {"gauges-height-17_3", {.value = 0.032, .width = 0.00075, .reason = why}},
      {"gauges-misfit-17_3", {.value = 0.00589, .width = 0.00077, .reason = why}},
      {"gauges-harmonic-1-17_3", {.value = 0.00665, .width = 0.00021, .reason = why}},
      {"gauges-height-19", {.value = 0.0294, .width = 0.001, .reason = why}},
      {"gauges-misfit-19", {.value = 0.00575, .width = 0.00098, .reason = why}},
      {"gauges-harmonic-1-19", {.value = 0.00726, .width = 0.00016, .reason = why}},
      {"gauges-misfit-21", {.value = 0.00696, .width = 0.00083, .reason = why}},
      {"gauges-harmonic-1-21", {.value = 0.00717, .width = 0.00022, .reason = why}},
  };
}

Experiment experiment(const Values& values) {
  const double period = period_of(values);
  const bool long_wave = is_long(values);
  const Window window{0.51 * period, 0.51 * period + (long_wave ? 1 : 3) * period};
  Series part{.name = "gauges",
              .table = long_wave ? "luth_1994_bar_a" : "luth_1994_bar_c",
              .group = Column{"x", "m", "distance from the wavemaker"},
              .abscissa = {"t", "s", "time"},
              .quantity = {"eta", "m", "surface elevation"},
              .input = 0.03,
              .input_reason = "bar and beach reflect, as in the same test at twice the scale",
              .clock = Clock{.group = 2, .range = period / 2, .window = window},
              .readings = {}};
  for (const double x : gauges) {
    part.readings.push_back(height(x, window));
    part.readings.push_back(misfit(x, window));
    part.readings.push_back(
        harmonic(x, 1, period, window, 0.0005, "two records of the same wave differ by 0.3 to 0.5 mm"));
  }
  Experiment one{.source = source,
                 .parts = {part},
                 .files = {long_wave ? "luth_1994_bar_a/bed.csv" : "luth_1994_bar_c/bed.csv"},
                 .model = "dispersive shallow water, improved dispersion"};
  if (long_wave) {
    one.compute = compute;
    one.misses = misses();
  }
  return one;
}

}  // namespace

Case luth_bar() {
  Case c;
  c.title = "Regular waves over a submerged bar: the flume of Luth, Klopman and Kitou";
  c.source = source;
  c.parameters = {choice("wave", std::string("A"), {"A", "C"}, "the waves: 2.02 or 1.01 s"),
                  real("spacing", 0.02, "m", {0.01, 0.1}, "of the markers"), dispersion_parameter()};
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
