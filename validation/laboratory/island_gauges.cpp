/*
A solitary wave around a conical island in 0.32 m of water (Briggs and others 1995; NTHMP benchmark problem 6): waves A,
B and C, H/h = 0.0445, 0.0872 and 0.179.

**What is compared.** Surface elevation at four gauges around the island: maximum, its time, and the rms difference,
which is compared at the four gauges before the island too; run-up around the island. Levels before arrival are removed,
and one time shift is fitted at gauge 3, before the island. Records count until 36 s (A) and 35 s (B, C), when
reflections from the absorbers arrive according to the source; at gauge 22, behind the island, where the crests of A and
B arrive later, until one second after them. The case accepts external results; in the tier `full` the same claims score
the 2DH model, on the rezoned mesh of `conical_island`, from solitary waves whose heights, H/h = 0.0445, 0.0872 and
0.179, are the mean of gauges 1 to 4. Wave heights there are shown and not scored. A gauge that falls dry reads the bed.

**What to look at.** Two published versions of the same run-up differ by a factor of up to 1.88. The reference is their
mean, with half of their difference over $\sqrt3$ as standard uncertainty. The stated height of B is H/h = 0.096; the
records show 0.087. See `--set wave=B` and `--set wave=C`, which breaks.
*/
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "validation/instruments/plan/island_flow.hpp"
#include "validation/instruments/plan/plan_gauges.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::island_gauges {

using namespace laboratory;

struct Wave {
  std::string table;
  double letter;
  double height;  ///< in front of the island, mean of gauges 1 to 4, over the depth
  double front;   ///< x of these gauges from the middle of the island [m]
  double passes;  ///< when the crest is there
  double until;   ///< the source's end of what is judged; later absorbers are felt
  double lee;     ///< likewise behind the island, gauge 22: a second after its crest; no echo is there before 40 s
};

Wave wave_of(const Values& values) {
  if (values.text("wave") == "A") return {"briggs_1995_conical_island_a", 1, 0.0445, -7.2, 28.80, 36, 37.5};
  if (values.text("wave") == "B") return {"briggs_1995_conical_island_b", 2, 0.0872, -6.14, 28.30, 35, 36.3};
  return {"briggs_1995_conical_island_c", 3, 0.179, -5.4, 27.80, 35, 35};
}

struct Gauge {
  double number;
  Point place;  ///< from the middle of the island; half of the basin is computed
};

std::array<Gauge, 8> gauges_of(const Wave& wave) {
  return {Gauge{1, {wave.front, 2.25}}, Gauge{2, {wave.front, 0.75}}, Gauge{3, {wave.front, 0.75}},
          Gauge{4, {wave.front, 2.25}}, Gauge{6, {-3.6, 0}},          Gauge{9, {-2.6, 0}},
          Gauge{16, {0, 2.58}},         Gauge{22, {2.6, 0}}};
}

Submitted compute(const Run& run, double coarsening) {
  const Wave wave = wave_of(run);
  const ConicalIsland island({.height = wave.height, .depth = 0.32, .spacing = coarsening * run.real("spacing")});
  auto flow = island.rezoned_flow();
  std::vector<Point> places;
  std::vector<SubmittedGroup> records;
  for (const Gauge& gauge : gauges_of(wave)) {
    places.push_back(gauge.place);
    records.push_back({.value = gauge.number});
  }
  const auto note = [&](double time, std::size_t k, double eta) {
    records[k].abscissa.push_back(time);
    records[k].values["eta"].push_back(eta);
  };
  // The flow begins with the crest at this time of the experiment where it is then; before, the wave came undisturbed.
  const double begin = wave.passes - (wave.front - island.crest()) / island.wave().speed();
  for (double time = begin - 4; time < begin - 0.01; time += 0.05) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double behind = places[k].x - island.crest() - island.wave().speed() * (time - begin);
      note(time, k, island.wave().elevation(behind));
    }
  }
  PlanGauges gauges(flow.flow().shape(), places);
  RunupEnvelope envelope(flow.flow());
  const auto observe = [&] {
    const auto& now = flow.flow();
    envelope.observe(now, flow.time());
    const auto eta = gauges.read({now.x(), now.y(), now.z()});
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double dry = island.bottom(places[k].x, places[k].y);
      note(begin + flow.time(), k, std::isnan(eta[k]) ? dry : eta[k]);
    }
  };
  observe();
  march(flow, island.passage() + 6, island.step(), observe);
  return {{"gauges", records},
          {"runup", {{.value = 0, .abscissa = envelope.angle(), .values = {{"R", envelope.runup()}}}}}};
}

Experiment experiment(const Values& values) {
  const Wave wave = wave_of(values);
  Series gauges{.table = wave.table,
                .group = Column{"gauge", "1", "number"},
                .abscissa = {"t", "s", "time of the experiment"},
                .still = Window{20, 22.5},
                .input = 0.02,
                .input_reason = "height of the wave along its crest",
                .telling = 1.5,
                .origin = wave.passes,
                .clock = Clock{.group = 3, .range = 1, .window = {24, wave.passes + 3}},
                .calibrating = {1, 2, 3, 4}};
  for (const double gauge : {1.0, 2.0, 3.0, 4.0, 6.0, 9.0, 16.0, 22.0}) {
    const Window window{24, gauge == 22 ? wave.lee : wave.until};
    gauges.readings.push_back(highest(gauge, window));
    if (gauge > 4) gauges.readings.push_back(when_highest(gauge, window));
    gauges.readings.push_back(misfit(gauge, window));
  }
  Series runup{.name = "runup",
               .table = "briggs_1995_conical_island_runup",
               .kind = WantedTable::Kind::profile,
               .abscissa = {"angle", "deg", "angle from the front of the island"},
               .quantity = {"R", "m", "maximum run-up"},
               .columns = {"R_nthmp", "R_liu"},
               .rows = {{"case", wave.letter}}};
  for (const double angle : {0, 45, 90, 135, 180}) runup.readings.push_back(at(0, angle, Kind::run_up));
  return {
      .source =
          "M. J. Briggs, C. E. Synolakis, G. S. Harkins, D. R. Green, Pure Appl. Geophys. 144 (1995) 569-593; P. L.-F. "
          "Liu et al., J. Fluid Mech. 302 (1995) 259-285",
      .parts = {gauges, runup},
      .files = {"briggs_1995_conical_island_a/bathymetry.asc", wave.table + "/gauges.csv", wave.table + "/paddle.csv"},
      .compute = values.tier() == Tier::quick ? nullptr : compute,
      .model = "dispersive shallow water, 2DH",
      .coarsenings = {1, 1.5, 2},
      .miss = wave.letter < 3
                  ? "behind its crest the experimental wave is not a solitary wave: the surface at gauges 1 to 4 falls "
                    "below the still-water level and stays there, while the model shows the reflection from the island"
                  : "the wave breaks on the island: the model dissipates less energy than the bore of the experiment"};
}

void island_gauges(Case& c) {
  c.tiers = {Tier::quick, Tier::full};
  set_laboratory<experiment>(
      c, "A solitary wave around a conical island: gauges and run-up",
      {choice("wave", "A", {"A", "B", "C"}, "the wave: H/h = 0.0445 (A), 0.0872 (B) or 0.179 (C)"),
       real("spacing", 0.25, "m", {0.2, 0.5}, "column width along the walls of the basin, for the model run")});
}

}  // namespace seiche::validation::cases::island_gauges
