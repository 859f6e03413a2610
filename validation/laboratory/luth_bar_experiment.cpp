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
      "velocities; this model loses none, its waves stay higher, and the first harmonic runs up to 0.1 s ahead";
  return {
      {"gauges-height-12_5", {.value = 0.0363, .width = 0.00043, .reason = why}},
      {"gauges-misfit-12_5", {.value = 0.00215, .width = 0.00027, .reason = why}},
      {"gauges-height-13_5", {.value = 0.0389, .width = 0.00046, .reason = why}},
      {"gauges-misfit-13_5", {.value = 0.00251, .width = 0.00031, .reason = why}},
      {"gauges-height-14_5", {.value = 0.0382, .width = 0.0012, .reason = why}},
      {"gauges-misfit-14_5", {.value = 0.00429, .width = 0.00054, .reason = why}},
      {"gauges-misfit-15_7", {.value = 0.0018, .width = 0.00023, .reason = why}},
      {"gauges-harmonic-1-15_7", {.value = 0.00727, .width = 0.00016, .reason = why}},
      {"gauges-height-17_3", {.value = 0.0381, .width = 0.00042, .reason = why}},
      {"gauges-misfit-17_3", {.value = 0.00357, .width = 0.0012, .reason = why}},
      {"gauges-harmonic-1-17_3", {.value = 0.00691, .width = 0.0002, .reason = why}},
      {"gauges-height-19", {.value = 0.0292, .width = 0.0021, .reason = why}},
      {"gauges-misfit-19", {.value = 0.00265, .width = 0.00092, .reason = why}},
      {"gauges-height-21", {.value = 0.0345, .width = 0.0036, .reason = why}},
      {"gauges-misfit-21", {.value = 0.00226, .width = 0.0012, .reason = why}},
      {"gauges-harmonic-1-21", {.value = 0.00689, .width = 0.00015, .reason = why}},
  };
}

std::map<std::string, evidence::KnownFailure> misses_c() {
  const std::string why =
      "waves of k h = 1.7 are 1 % too slow here, 0.05 s at the foot of the bar; the second harmonic runs free behind "
      "it "
      "with k h = 6.4, where they are 1.12 times too fast; and the harmonics that were measured carry 19 to 36 % less "
      "energy behind the bar than before it, by Airy's group velocities, while this model loses none";
  return {
      {"gauges-misfit-2", {.value = 0.00233, .width = 0.00029, .reason = why}},
      {"gauges-misfit-4", {.value = 0.0022, .width = 0.00027, .reason = why}},
      {"gauges-misfit-10_5", {.value = 0.00447, .width = 0.00056, .reason = why}},
      {"gauges-misfit-12_5", {.value = 0.00265, .width = 0.00033, .reason = why}},
      {"gauges-height-13_5", {.value = 0.0457, .width = 0.00049, .reason = why}},
      {"gauges-misfit-13_5", {.value = 0.00228, .width = 0.00034, .reason = why}},
      {"gauges-misfit-14_5", {.value = 0.00459, .width = 0.00057, .reason = why}},
      {"gauges-harmonic-1-14_5", {.value = 0.0199, .width = 0.00047, .reason = why}},
      {"gauges-misfit-15_7", {.value = 0.00319, .width = 0.0018, .reason = why}},
      {"gauges-harmonic-1-15_7", {.value = 0.0202, .width = 0.00029, .reason = why}},
      {"gauges-misfit-17_3", {.value = 0.00466, .width = 0.0022, .reason = why}},
      {"gauges-harmonic-1-17_3", {.value = 0.0201, .width = 0.00026, .reason = why}},
      {"gauges-misfit-19", {.value = 0.00741, .width = 0.0038, .reason = why}},
      {"gauges-harmonic-1-19", {.value = 0.0205, .width = 0.00057, .reason = why}},
      {"gauges-height-21", {.value = 0.043, .width = 0.0029, .reason = why}},
      {"gauges-misfit-21", {.value = 0.00467, .width = 0.0028, .reason = why}},
      {"gauges-harmonic-1-21", {.value = 0.0199, .width = 0.0011, .reason = why}},
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
