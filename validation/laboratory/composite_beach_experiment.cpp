#include "validation/laboratory/composite_beach_experiment.hpp"

#include <cmath>

#include "seiche/samples.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::laboratory {
namespace {

constexpr double depth = 0.218;

const std::string miss =
    "arrivals at gauges 8 to 10: between 7 and 8 the measured wave is slower than sqrt(g depth), 1.34 s for 1.46 m "
    "instead of 1.29 s; the measured run-up, 0.0274 m, exceeds twice the height of a long wave by Green's law at the "
    "wall, 0.024 m, while the gauge before the wall agrees";
const std::string breaking_miss =
    "the measured height falls from H/h = 0.68 to 0.59 between gauges 4 and 6, before breaking on the slope; Serre's "
    "solitary wave retains its height there and is broader than the wave of the Euler equations at this height, and "
    "therefore runs too fast and loses more as a bore";

/// Of a wave: its letter, the place of gauge 4, when the crest passes there, and how high [m].
struct Wave {
  std::string table;
  double letter, gauge, passes, height;

  [[nodiscard]] bool breaks() const { return letter > 1; }
};

Wave wave_of(const std::string& letter) {
  if (letter == "A") return {"briggs_1996_composite_beach_a", 1, 12.64, 271.50, 0.0082};
  if (letter == "B") return {"briggs_1996_composite_beach_b", 2, 14.06, 269.95, 0.0564};
  return {"briggs_1996_composite_beach_c", 3, 14.40, 268.90, 0.1484};
}

Submitted compute(const Run& run, const Wave& wave, double coarsening) {
  const double spacing = coarsening * run.real("spacing");
  Flume flume{.bed_x = {-20, 15.04, 19.40, 22.33, 23.23},
              .bed_z = {-depth, -depth, -0.1357, -0.1162, -0.0470},
              .spacing = spacing,
              .tau = spacing / 2,
              .friction = glass};
  const double crest = 4;
  const double amplitude = (wave.breaks() ? 0.681 : 0.0378) * depth;
  if (wave.breaks()) flume.breaking = dispersive::Breaking{};
  dispersive::Flow flow = solitary_waves(flume, {{.depth = depth, .amplitude = amplitude, .crest = crest}});
  const double speed = std::sqrt(flume.gravity * (depth + amplitude));
  const double start = wave.passes - (wave.gauge - crest) / speed;
  const std::vector<double> groups{4, 5, 6, 7, 8, 9, 10, 0};  // the last: the wall
  const std::vector<double> places{wave.gauge, 15.04, 17.22, 19.40, 20.86, 22.33, 22.80, 23.23 - 1e-6};
  std::vector<SubmittedGroup> records = gauge_records(flow, flume, groups, places, 0.05, 291 - start, -start);
  const double run_up = largest(records.back().values.at("eta"));
  records.pop_back();
  return {{"gauges", records}, {"runup", {{.value = 0, .abscissa = {}, .values = {{"R", {run_up}}}}}}};
}

}  // namespace

Experiment composite_beach_experiment(const std::string& letter) {
  const Wave wave = wave_of(letter);
  Series gauges{.table = wave.table,
                .group = Column{"gauge", "1", "number"},
                .abscissa = {"t", "s", "time of the experiment"},
                .still = Window{265, 267},
                .input = 0.02,
                .input_reason = "calibration of the gauges, estimated",
                .telling = 1,
                .origin = wave.passes,
                .clock = Clock{.group = 4, .range = 1, .window = {267, wave.passes + 2}},
                .calibrating = {4}};
  for (double gauge = 4; gauge <= 10; ++gauge) {
    const Window window{267, gauge == 4 ? 277.0 : 284.0};
    gauges.readings.push_back(highest(gauge, window));
    if (gauge > 4) gauges.readings.push_back(arrival(gauge, wave.height / 2, window));
    gauges.readings.push_back(misfit(gauge, window));
  }
  Series runup{.name = "runup",
               .table = "briggs_1996_composite_beach_runup",
               .kind = WantedTable::Kind::scalars,
               .abscissa = {"case", "1", "wave"},
               .quantity = {"R", "m", "maximum run-up on the wall"},
               .rows = {{"case", wave.letter}},
               .input = 0.02,
               .input_reason = "wave height: stated and recorded values differ by 2 to 3 %",
               .readings = {at(0, wave.letter, Kind::run_up)}};
  Experiment one{.source = composite_beach_source,
                 .parts = {gauges, runup},
                 .files = {wave.table + "/bed.csv", wave.table + "/gauges.csv", wave.table + "/paddle.csv"},
                 .model = wave.breaks() ? "dispersive shallow water with breaking" : "dispersive shallow water"};
  if (letter != "B") {
    one.compute = [wave](const Run& run, double coarsening) { return compute(run, wave, coarsening); };
    one.miss = wave.breaks() ? breaking_miss : miss;
  }
  return one;
}

}  // namespace seiche::validation::laboratory
