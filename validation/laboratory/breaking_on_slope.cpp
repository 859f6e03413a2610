/*
Regular waves climb a 1:34 slope and break (Hansen and Svendsen 1979): period 3.33 s, plunging, and 1.67 s, spilling.

**What is compared.** Wave height and mean level along the slope: maximum height, its position, and the rms difference
before breaking. The case accepts external results; in the longer tiers the same claims score the one-dimensional
dispersive model with breaking, driven by cnoidal waves of the measured height at the toe, over a glass bed, over the
three periods after 30 s, when the front of the wave train has passed the slope.

**What to look at.** Drive the waves with a wave of permanent form and the measured height at the toe, 0.0406 and 0.0695
m: linear wavemakers generate free second harmonics that beat along the flat.
*/
#include <algorithm>

#include "seiche/samples.hpp"
#include "validation/laboratory/laboratory_case.hpp"
#include "validation/studies/dispersive_shallow_water/dispersive_flume.hpp"

namespace seiche::validation::cases::breaking_on_slope {

using namespace laboratory;

struct Wave {
  double number, period, height;
};

/// Height and mean level along the slope over three periods, when the front of the train has gone up it.
void add_wave(const Wave& wave, double spacing, Submitted& submitted) {
  const double slope = 1 / 34.26;
  const double depth = 0.36;
  const Flume flume{.bed_x = {-110, -depth / slope, 0, 0.2 / slope},
                    .bed_z = {-depth, -depth, 0, 0.2},
                    .spacing = spacing,
                    .tau = spacing / 3,
                    .shoreline = true,
                    .friction = glass,
                    .breaking = dispersive::Breaking{}};
  const double toe = -depth / slope;
  dispersive::Flow flow =
      cnoidal_waves(flume, {.depth = depth, .height = wave.height, .period = wave.period, .from = -106, .to = toe});
  march(flow, 30, stable_steps(flow, flume.tau));
  std::vector<double> places;
  for (double x = 0; x < 10.5; x += 0.05) places.push_back(toe + x);
  constexpr long periods = 3;
  constexpr long instants = 64;  // of a period
  std::vector<Mean> height(places.size());
  std::vector<Mean> level(places.size());
  const double begin = flow.time();
  for (long period = 0; period < periods; ++period) {
    std::vector<std::vector<double>> records(places.size());
    for (long k = 1; k <= instants; ++k) {
      march(flow, begin + wave.period * static_cast<double>(period * instants + k) / instants,
            stable_steps(flow, flume.tau));
      const std::vector<double> eta = flow.elevation_at(places);
      for (const std::size_t i : indices(places.size())) {
        records[i].push_back(eta[i]);
        level[i].add(eta[i]);
      }
    }
    for (const std::size_t i : indices(places.size())) height[i].add(largest(records[i]) - smallest(records[i]));
  }
  const std::vector<double> x = each(places, [toe](double place) { return place - toe; });
  const auto add = [&](const std::string& table, const std::string& column, const std::vector<Mean>& means) {
    submitted[table].push_back({.value = wave.number, .abscissa = x, .values = {{column, each(means, &Mean::value)}}});
  };
  add("heights", "H", height);
  add("levels", "level", level);
}

Submitted compute(const Run& run, double coarsening) {
  Submitted submitted;
  for (const Wave& wave : {Wave{1, 1 / 0.3, 0.0406}, Wave{2, 1 / 0.6, 0.0695}}) {
    add_wave(wave, coarsening * run.real("spacing"), submitted);
  }
  return submitted;
}

Experiment experiment(const Values& values) {
  Series heights{.name = "heights",
                 .table = "hansen_svendsen_1979_shoaling_breaking",
                 .kind = WantedTable::Kind::profile,
                 .group = Column{"case", "1", "1: 3.33 s, 2: 1.67 s"},
                 .abscissa = {"x", "m", "distance from the toe of the slope"},
                 .quantity = {"H", "m", "wave height"},
                 .input = 0.02,
                 .input_reason = "height at the toe, standard deviation of eight points",
                 .telling = 1.5};
  Series levels = heights;
  levels.name = "levels";
  levels.quantity = {"level", "m", "mean level"};
  levels.input = 0.04;  // a set-down goes with the square of the height
  levels.input_reason = "twice the uncertainty of the height, to whose square it is proportional";
  for (const double wave : {1, 2}) {
    const double breaking = wave == 1 ? 9.15 : 8.22;
    heights.read({highest(wave, {}), when_highest(wave, {}, Kind::place), misfit(wave, {0, breaking})});
    levels.readings.push_back(misfit(wave, {0, breaking}));
  }
  return {.source =
              "J. B. Hansen, I. A. Svendsen, Regular waves in shoaling water: experimental data, Series Paper 21, "
              "ISVA, Technical University of Denmark (1979)",
          .parts = {heights, levels},
          .files = {"hansen_svendsen_1979_shoaling_breaking/bed.csv"},
          .compute = values.tier() == Tier::quick ? nullptr : compute,  // coarser spacings place no breaking to 1.5 m
          .model = "dispersive shallow water with breaking",
          .coarsenings = {1, 1.5, 2},
          .miss =
              "cause unknown: the set-down before breaking of the long wave is 1.0 mm, compared with 1.7 mm measured, "
              "and the computed height undulates by 3 mm along the slope, unlike the measured one; maximum heights and "
              "breaking points agree. Waves of the Euler equations at the toe would show whether the boundary "
              "condition is the cause"};
}

void breaking_on_slope(Case& c) {
  set_laboratory<experiment>(c, "Shoaling and breaking of regular waves on a slope",
                             {real("spacing", {0.1, 0.04, 0.04}, "m", {0.01, 0.1}, "node spacing, for the model run")});
}

}  // namespace seiche::validation::cases::breaking_on_slope
