#include "validation/laboratory/luth_bar_experiment.hpp"

#include <map>
#include <vector>

#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::laboratory {
namespace {

const std::vector<double> gauges{2, 4, 10.5, 12.5, 13.5, 14.5, 15.7, 17.3, 19, 21};

struct BarWave {
  std::string table;
  double period = 0;     ///< [s]
  double amplitude = 0;  ///< first harmonic at the two gauges before the bar [m]
  double steady = 0;     ///< when the slowest harmonics have come to the last gauge [s]
  double periods = 0;    ///< that are compared
  double input = 0;      ///< relative standard uncertainty of the amplitude
  std::string input_reason = {};
  std::string miss = {};
};

const BarWave wave_a{
    "luth_1994_bar_a",
    2.02,
    0.0108,
    28,
    1,
    0.08,
    "the amplitude is 0.0108 m at the two gauges before the bar, 0.0100 m nominally",
    "the energy flux of the measured harmonics is 31 to 36 % lower behind the bar than before it, by Airy's group "
    "velocities; this model is energy-conserving, its waves are higher, and the first harmonic leads by up to 0.1 s"};
// The front comes to the bar at 0.9 m/s, what is set free there at 12 to 14 m goes on with 0.4 m/s.
const BarWave wave_c{
    "luth_1994_bar_c",
    1.01,
    0.0206,
    40,
    3,
    0.03,
    "reflection from bar and beach, as in the same test at twice the scale",
    "the celerity at k h = 1.7 is 1 % too low, a lag of 0.05 s at the foot of the bar; the free second harmonic behind "
    "the bar has k h = 6.4, where the celerity is 12 % too high; and the energy flux of the measured harmonics is 19 "
    "to 36 % lower behind the bar than before it, by Airy's group velocities, while this model is energy-conserving"};

Submitted compute(const BarWave& wave, const Run& run, double coarsening) {
  const double spacing = coarsening * run.real("spacing");
  const Flume flume{.bed_x = {-90, 6, 12, 14, 17, 60},
                    .bed_z = {-0.4, -0.4, -0.1, -0.1, -0.4, -0.4},
                    .spacing = spacing,
                    .tau = spacing / 3,
                    .gamma = gamma_of(run.text("dispersion"))};
  dispersive::Flow flow =
      regular_waves(flume, {.depth = 0.4, .amplitude = wave.amplitude, .period = wave.period, .from = -80, .to = 0});
  march(flow, wave.steady - 2, stable_steps(flow, flume.tau));
  return {{"gauges", gauge_records(flow, flume, gauges, gauges, 0.02, wave.steady + 7, wave.steady)}};
}

}  // namespace

Experiment luth_bar_experiment(const std::string& letter) {
  const BarWave& wave = letter == "A" ? wave_a : wave_c;
  const Window window{0.51 * wave.period, 0.51 * wave.period + wave.periods * wave.period};
  Series part{.table = wave.table,
              .group = Column{"x", "m", "distance from the wavemaker"},
              .abscissa = {"t", "s", "time"},
              .input = wave.input,
              .input_reason = wave.input_reason,
              .clock = Clock{.group = 2, .range = wave.period / 2, .window = window},
              .calibrating = {2, 4}};
  for (const double x : gauges) {
    part.read({height(x, window), misfit(x, window)});
    constexpr double repeats = 0.0005;  // two records of the same wave differ by 0.3 to 0.5 mm
    part.readings.push_back(harmonic(x, 1, wave.period, window, repeats));
  }
  return {.source = luth_bar_source,
          .parts = {part},
          .files = {wave.table + "/bed.csv"},
          .compute = [wave](const Run& run, double coarsening) { return compute(wave, run, coarsening); },
          .model = "dispersive shallow water, improved dispersion",
          .miss = wave.miss};
}

}  // namespace seiche::validation::laboratory
