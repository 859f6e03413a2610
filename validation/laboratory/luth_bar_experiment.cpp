#include "validation/laboratory/luth_bar_experiment.hpp"

#include <map>
#include <vector>

#include "validation/laboratory/dispersive_flume.hpp"

namespace seiche::validation::laboratory {
namespace {

const std::vector<double> gauges{2, 4, 10.5, 12.5, 13.5, 14.5, 15.7, 17.3, 19, 21};

struct Wave {
  std::string table;
  double period = 0;     ///< [s]
  double amplitude = 0;  ///< first harmonic at the two gauges before the bar [m]
  double steady = 0;     ///< when the slowest harmonics have come to the last gauge [s]
  double periods = 0;    ///< that are compared
};

const Wave wave_a{"luth_1994_bar_a", 2.02, 0.0108, 28, 1};
// The front comes to the bar at 0.9 m/s, what is set free there at 12 to 14 m goes on with 0.4 m/s.
const Wave wave_c{"luth_1994_bar_c", 1.01, 0.0206, 40, 3};

Submitted compute(const Wave& wave, const Run& run, double coarsening) {
  const double spacing = coarsening * run.real("spacing");
  const Flume flume{.bed_x = {-90, 6, 12, 14, 17, 60},
                    .bed_z = {-0.4, -0.4, -0.1, -0.1, -0.4, -0.4},
                    .spacing = spacing,
                    .tau = spacing / 3,
                    .gamma = gamma_of(run.text("dispersion"))};
  dispersive::Flow flow =
      regular_waves(flume, {.depth = 0.4, .amplitude = wave.amplitude, .period = wave.period, .from = -80, .to = 0});
  flow.advance_to(wave.steady - 2, flume.tau);
  return {{"gauges", gauge_records(flow, flume, gauges, gauges, 0.02, wave.steady + 7, wave.steady)}};
}

/// At the standard parameters; a band is a half more than what twice the spacing changes, or an eighth of what is
/// missed.
std::map<std::string, evidence::KnownFailure> misses_a() {
  const std::string why =
      "the harmonics that were measured carry 31 to 36 % less energy behind the bar than before it, by Airy's group "
      "velocities; this model loses none, its waves stay higher, and higher ones run 0.05 to 0.1 s ahead";
  return {
      {"gauges-height-12_5", {.value = 0.0366, .width = 0.00046, .reason = why}},
      {"gauges-misfit-12_5", {.value = 0.00234, .width = 0.00029, .reason = why}},
      {"gauges-height-13_5", {.value = 0.0391, .width = 0.00037, .reason = why}},
      {"gauges-misfit-13_5", {.value = 0.00293, .width = 0.00037, .reason = why}},
      {"gauges-height-14_5", {.value = 0.0388, .width = 0.00093, .reason = why}},
      {"gauges-misfit-14_5", {.value = 0.00519, .width = 0.00075, .reason = why}},
      {"gauges-height-15_7", {.value = 0.0304, .width = 0.0019, .reason = why}},
      {"gauges-misfit-15_7", {.value = 0.00313, .width = 0.00093, .reason = why}},
      {"gauges-harmonic-1-15_7", {.value = 0.00725, .width = 0.00016, .reason = why}},
      {"gauges-misfit-17_3", {.value = 0.00632, .width = 0.00087, .reason = why}},
      {"gauges-harmonic-1-17_3", {.value = 0.00669, .width = 0.00018, .reason = why}},
      {"gauges-height-19", {.value = 0.0321, .width = 0.0012, .reason = why}},
      {"gauges-misfit-19", {.value = 0.00645, .width = 0.0011, .reason = why}},
      {"gauges-harmonic-1-19", {.value = 0.00731, .width = 0.00014, .reason = why}},
      {"gauges-misfit-21", {.value = 0.00772, .width = 0.00097, .reason = why}},
      {"gauges-harmonic-1-21", {.value = 0.00722, .width = 0.00019, .reason = why}},
  };
}

std::map<std::string, evidence::KnownFailure> misses_c() {
  const std::string why =
      "the harmonics that were measured carry 19 to 36 % less energy behind the bar than before it, by Airy's group "
      "velocities, and this model loses none: its waves stay higher and run 0.1 s, a tenth of the period, ahead from "
      "the top of the bar on; the second harmonic runs free with k h = 6.4, where they are 1.2 times too fast";
  return {
      {"gauges-misfit-4", {.value = 0.00313, .width = 0.00039, .reason = why}},
      {"gauges-misfit-10_5", {.value = 0.00241, .width = 0.0003, .reason = why}},
      {"gauges-height-12_5", {.value = 0.0489, .width = 0.00051, .reason = why}},
      {"gauges-misfit-12_5", {.value = 0.0119, .width = 0.0015, .reason = why}},
      {"gauges-height-13_5", {.value = 0.0466, .width = 0.0013, .reason = why}},
      {"gauges-misfit-13_5", {.value = 0.01, .width = 0.0013, .reason = why}},
      {"gauges-harmonic-1-13_5", {.value = 0.0206, .width = 0.00051, .reason = why}},
      {"gauges-height-14_5", {.value = 0.0497, .width = 0.0031, .reason = why}},
      {"gauges-misfit-14_5", {.value = 0.0144, .width = 0.0022, .reason = why}},
      {"gauges-height-15_7", {.value = 0.0448, .width = 0.0011, .reason = why}},
      {"gauges-misfit-15_7", {.value = 0.0121, .width = 0.0026, .reason = why}},
      {"gauges-misfit-17_3", {.value = 0.0102, .width = 0.0013, .reason = why}},
      {"gauges-harmonic-1-17_3", {.value = 0.0202, .width = 0.00074, .reason = why}},
      {"gauges-misfit-19", {.value = 0.0103, .width = 0.002, .reason = why}},
      {"gauges-harmonic-1-19", {.value = 0.0206, .width = 0.00058, .reason = why}},
      {"gauges-height-21", {.value = 0.0427, .width = 0.001, .reason = why}},
      {"gauges-misfit-21", {.value = 0.0124, .width = 0.0039, .reason = why}},
      {"gauges-harmonic-1-21", {.value = 0.0195, .width = 0.00056, .reason = why}},
  };
}

}  // namespace

Experiment luth_bar_experiment(const std::string& letter) {
  const bool long_wave = letter == "A";
  const Wave& wave = long_wave ? wave_a : wave_c;
  const Window window{0.51 * wave.period, 0.51 * wave.period + wave.periods * wave.period};
  Series part{.name = "gauges",
              .table = wave.table,
              .group = Column{"x", "m", "distance from the wavemaker"},
              .abscissa = {"t", "s", "time"},
              .quantity = {"eta", "m", "surface elevation"},
              .input = 0.03,
              .input_reason = "bar and beach reflect, as in the same test at twice the scale",
              .clock = Clock{.group = 2, .range = wave.period / 2, .window = window},
              .readings = {}};
  for (const double x : gauges) {
    part.readings.push_back(height(x, window));
    part.readings.push_back(misfit(x, window));
    part.readings.push_back(
        harmonic(x, 1, wave.period, window, 0.0005, "two records of the same wave differ by 0.3 to 0.5 mm"));
  }
  return {.source = luth_bar_source,
          .parts = {part},
          .files = {wave.table + "/bed.csv"},
          .compute = [wave](const Run& run, double coarsening) { return compute(wave, run, coarsening); },
          .model = "dispersive shallow water, improved dispersion",
          .misses = long_wave ? misses_a() : misses_c()};
}

}  // namespace seiche::validation::laboratory
