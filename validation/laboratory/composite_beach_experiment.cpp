#include "validation/laboratory/composite_beach_experiment.hpp"

#include <algorithm>
#include <cmath>

#include "validation/laboratory/dispersive_flume.hpp"

namespace seiche::validation::laboratory {
namespace {

constexpr double depth = 0.218;

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
              .tau = spacing / 2};
  const double crest = 4;
  const double amplitude = (wave.breaks() ? 0.681 : 0.0378) * depth;
  if (wave.breaks()) {
    flume.friction = {dispersive::FrictionLaw::manning, 0.01};
    flume.breaking = dispersive::Breaking{};
  }
  dispersive::Flow flow = solitary_waves(flume, {{.depth = depth, .amplitude = amplitude, .crest = crest}});
  const double speed = std::sqrt(flume.gravity * (depth + amplitude));
  const double start = wave.passes - (wave.gauge - crest) / speed;
  const std::vector<double> groups{4, 5, 6, 7, 8, 9, 10, 0};  // the last: the wall
  const std::vector<double> places{wave.gauge, 15.04, 17.22, 19.40, 20.86, 22.33, 22.80, 23.23 - 1e-6};
  std::vector<SubmittedGroup> records = gauge_records(flow, flume, groups, places, 0.05, 291 - start, -start);
  const std::vector<double>& wall = records.back().values.at("eta");
  const double run_up = *std::max_element(wall.begin(), wall.end());
  records.pop_back();
  return {{"gauges", records}, {"runup", {{.value = 0, .abscissa = {}, .values = {{"R", {run_up}}}}}}};
}

/// At the standard parameters; a band is a half more than what twice the spacing changes, or an eighth.
std::map<std::string, evidence::KnownFailure> misses() {
  const std::string slow =
      "between gauges 7 and 8 the measured wave is slower than sqrt(g depth), 1.34 s for 1.46 m instead of 1.29 s: "
      "what brakes it is not the bottom: friction of glass, Manning's n = 0.01, makes it later by less than 0.05 s";
  const std::string bound =
      "0.0274 m, written as 0.09 feet, is more than the doubling of a long wave after Green's law gives at the wall, "
      "0.024 m; the gauge before the wall agrees";
  return {
      {"gauges-arrival-8", {.value = 276.82, .width = 0.023, .reason = slow}},
      {"gauges-arrival-9", {.value = 278.08, .width = 0.027, .reason = slow}},
      {"gauges-arrival-10", {.value = 278.46, .width = 0.031, .reason = slow}},
      {"runup-at-1", {.value = 0.0214, .width = 0.0009, .reason = bound}},
  };
}

/// Likewise; bands of three numerical uncertainties at least, and of 8 ms for the times.
std::map<std::string, evidence::KnownFailure> misses_of_breaking() {
  const std::string tall =
      "the wave falls from 0.68 to 0.59 depths between gauges 4 and 6 in the flume, before the slope makes it break; "
      "Serre's solitary wave keeps its height there and is broader than the Euler equations' of so great a height";
  const std::string early =
      "a wave that is too high runs too fast: it is early by what it was at the gauge before, and more";
  const std::string shape =
      "the bore comes from a wave that was too high and lost more, and the viscosity that leaves no waves behind it "
      "leaves none on the wave that comes back from the wall either";
  return {
      {"gauges-misfit-4", {.value = 0.0032, .width = 0.0004, .reason = tall}},
      {"gauges-highest-5", {.value = 0.1463, .width = 0.0011, .reason = tall}},
      {"gauges-arrival-5", {.value = 269.04, .width = 0.008, .reason = early}},
      {"gauges-misfit-5", {.value = 0.0130, .width = 0.0016, .reason = tall}},
      {"gauges-highest-6", {.value = 0.1513, .width = 0.0028, .reason = tall}},
      {"gauges-arrival-6", {.value = 270.21, .width = 0.018, .reason = early}},
      {"gauges-misfit-6", {.value = 0.0148, .width = 0.0019, .reason = tall}},
      {"gauges-highest-7", {.value = 0.1654, .width = 0.0031, .reason = tall}},
      {"gauges-arrival-7", {.value = 271.41, .width = 0.024, .reason = early}},
      {"gauges-misfit-7", {.value = 0.0190, .width = 0.0024, .reason = tall}},
      {"gauges-highest-8", {.value = 0.0961, .width = 0.0014, .reason = shape}},
      {"gauges-arrival-8", {.value = 272.21, .width = 0.029, .reason = early}},
      {"gauges-misfit-8", {.value = 0.0159, .width = 0.002, .reason = shape}},
      {"gauges-highest-9", {.value = 0.0922, .width = 0.0014, .reason = shape}},
      {"gauges-arrival-9", {.value = 273.12, .width = 0.032, .reason = early}},
      {"gauges-misfit-9", {.value = 0.0153, .width = 0.0019, .reason = shape}},
      {"gauges-highest-10", {.value = 0.1161, .width = 0.0045, .reason = shape}},
      {"gauges-arrival-10", {.value = 273.38, .width = 0.034, .reason = early}},
      {"gauges-misfit-10", {.value = 0.0179, .width = 0.0022, .reason = shape}},
  };
}

}  // namespace

Experiment composite_beach_experiment(const std::string& letter) {
  const Wave wave = wave_of(letter);
  Series gauges{.name = "gauges",
                .table = wave.table,
                .group = Column{"gauge", "1", "number"},
                .abscissa = {"t", "s", "time of the experiment"},
                .quantity = {"eta", "m", "surface elevation"},
                .still = Window{265, 267},
                .input = 0.02,
                .input_reason = "calibration of the gauges, estimated",
                .telling = 1,
                .origin = wave.passes,
                .clock = Clock{.group = 4, .range = 1, .window = {267, wave.passes + 2}},
                .readings = {}};
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
               .quantity = {"R", "m", "largest run-up on the wall"},
               .rows = {{"case", wave.letter}},
               .input = 0.02,
               .input_reason = "height of the wave: stated and recorded ones differ by 2 to 3 %",
               .readings = {at(0, wave.letter, Kind::run_up)}};
  Experiment one{.source = composite_beach_source,
                 .parts = {gauges, runup},
                 .files = {wave.table + "/bed.csv", wave.table + "/gauges.csv", wave.table + "/paddle.csv"},
                 .model = wave.breaks() ? "dispersive shallow water with breaking" : "dispersive shallow water"};
  if (letter != "B") {
    one.compute = [wave](const Run& run, double coarsening) { return compute(run, wave, coarsening); };
    one.misses = wave.breaks() ? misses_of_breaking() : misses();
  }
  return one;
}

}  // namespace seiche::validation::laboratory
