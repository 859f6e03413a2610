/*
A solitary wave around a conical island in 0.32 m of water (Briggs and others; NTHMP benchmark problem 6): waves A, B
and C, 0.045, 0.09 and 0.18 depths high.

**What is compared.** Surface elevation at four gauges before the island and four around it: highest value, when, and
the root mean square difference; run-up around the island. Levels before arrival are removed, and one shift of time is
fitted at gauge 3, before the island. The case scores others; the plan model, on the rezoned lattice of
`conical_island`, is judged by the same claims in the tier `full`, from solitary waves as high as gauges 1 to 4 have
them. A gauge that falls dry reads the bottom.

**What to look at.** Two distributions of the same run-up differ by up to 1.9: the mean of both is asked for, and half
of their distance is an uncertainty. The records show a wave B of 0.087 depths, not the 0.096 that is stated. With
`--tier full --set wave=B` the model's run-up is the measured one at all five angles and its crest at gauges 16 and 22
too; what follows the crest it misses at seven gauges, as of A; at gauge 9 its crest is 8 % too high, at gauge 16 0.13 s
late. Of C, which breaks, thirteen readings are missed: with columns 0.35 m apart crests at gauges 9, 16 and 22 by 20, 4
and 37 %, run-up at 90 and 135 degrees by 25 and 90 %; with columns 0.25 m apart these crests by 20, 5 and 19 % and that
of gauge 6 by 5 %, run-up at 90 degrees by 19 %, and at all others it is the measured one.
*/
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "validation/instruments/island_flow.hpp"
#include "validation/instruments/plan_gauges.hpp"
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::island_gauges {
namespace {

using namespace laboratory;

const std::string source =
    "M. J. Briggs, C. E. Synolakis, G. S. Harkins, D. R. Green, Pure Appl. Geophys. 144 (1995) 569-593; P. L.-F. Liu "
    "et "
    "al., J. Fluid Mech. 302 (1995) 259-285";

struct Wave {
  std::string table;
  double letter;
  double height;  ///< in front of the island, mean of gauges 1 to 4, over the depth
  double front;   ///< x of these gauges from the middle of the island [m]
  double passes;  ///< when the crest is there
  double until;
};

Wave wave_of(const Values& values) {
  if (values.text("wave") == "A") return {"briggs_1995_conical_island_a", 1, 0.045, -7.2, 28.80, 36};
  if (values.text("wave") == "B") return {"briggs_1995_conical_island_b", 2, 0.0872, -6.14, 28.30, 35};
  return {"briggs_1995_conical_island_c", 3, 0.179, -5.4, 27.80, 35};
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
    records.push_back({.value = gauge.number, .abscissa = {}, .values = {}});
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
  flow.advance_to(island.passage() + 6, island.step(), observe);
  return {{"gauges", records},
          {"runup", {{.value = 0, .abscissa = envelope.angle(), .values = {{"R", envelope.runup()}}}}}};
}

using Misses = std::map<std::string, evidence::KnownFailure>;

struct Miss {
  std::string reading;
  double value;
  std::string reason;
};

/// A band is an eighth of a misfit, a tenth of a run-up, a thirtieth of a height, and of a time a hundredth of what has
/// gone by since the crest was at gauges 1 to 4: what columns 0.35 and 0.25 m apart differ by is less than half of
/// it, but for wave C beside and behind the island.
Misses with_bands(const Wave& wave, const std::vector<Miss>& misses) {
  Misses declared;
  for (const Miss& miss : misses) {
    double width = miss.value / 30;
    if (miss.reading.starts_with("gauges-misfit")) width = miss.value / 8;
    if (miss.reading.starts_with("runup")) width = miss.value / 10;
    if (miss.reading.starts_with("gauges-when")) width = (miss.value - wave.passes) / 100;
    declared[miss.reading] = {.value = miss.value, .width = width, .reason = miss.reason};
  }
  return declared;
}

Misses misses(const Wave& wave) {
  const std::string behind =
      "behind its crest the wave of the experiment is no solitary wave: the surface at gauges 1 to 4 falls below its "
      "level and stays there, where the model has what the island sends back; crests and times agree";
  const std::string before =
      "in front of the island the model is higher from the crest on, as at gauges 1 to 4 later; finer columns do not "
      "change it";
  const std::string flank = "beside the island the crest comes late, by a thirtieth of its time since gauges 1 to 4";
  const std::string breaks =
      "the wave breaks on the island: the model's roller takes less from it than the experiment's bore lost";
  if (wave.letter == 1) {
    return with_bands(wave, {{"gauges-misfit-1", 0.00208, behind},
                             {"gauges-misfit-2", 0.00216, behind},
                             {"gauges-misfit-3", 0.0022, behind},
                             {"gauges-misfit-4", 0.00226, behind},
                             {"gauges-misfit-6", 0.00257, behind},
                             {"gauges-misfit-9", 0.00262, behind},
                             {"gauges-misfit-16", 0.00194, behind},
                             {"gauges-highest-6", 0.0172, before},
                             {"gauges-highest-9", 0.0251, before}});
  }
  if (wave.letter == 2) {
    return with_bands(wave, {{"gauges-misfit-1", 0.0032, behind},
                             {"gauges-misfit-2", 0.00362, behind},
                             {"gauges-misfit-3", 0.00379, behind},
                             {"gauges-misfit-4", 0.00335, behind},
                             {"gauges-misfit-6", 0.00383, behind},
                             {"gauges-misfit-9", 0.0043, behind},
                             {"gauges-misfit-16", 0.00296, behind},
                             {"gauges-highest-9", 0.0441, before},
                             {"gauges-when-16", 32.01, flank}});
  }
  return with_bands(wave, {{"gauges-misfit-1", 0.00552, behind},
                           {"gauges-misfit-2", 0.00613, behind},
                           {"gauges-misfit-3", 0.00622, behind},
                           {"gauges-misfit-4", 0.00577, behind},
                           {"gauges-misfit-6", 0.00733, behind},
                           {"gauges-misfit-9", 0.0101, breaks},
                           {"gauges-misfit-16", 0.00556, breaks},
                           {"gauges-misfit-22", 0.00836, breaks},
                           {"gauges-highest-9", 0.0762, breaks},
                           {"gauges-highest-16", 0.0637, breaks},
                           {"gauges-highest-22", 0.1073, breaks},
                           {"runup-at-90", 0.132, breaks},
                           {"gauges-highest-6", 0.0632, before}});
}

Experiment experiment(const Values& values) {
  const Wave wave = wave_of(values);
  Series gauges{.name = "gauges",
                .table = wave.table,
                .group = Column{"gauge", "1", "number"},
                .abscissa = {"t", "s", "time of the experiment"},
                .quantity = {"eta", "m", "surface elevation"},
                .still = Window{20, 22.5},
                .input = 0.02,
                .input_reason = "height of the wave along its crest",
                .telling = 1.5,
                .origin = wave.passes,
                .clock = Clock{.group = 3, .range = 1, .window = {24, wave.passes + 3}},
                .readings = {},
                .alike = 3,
                .alike_reason = "gauges 1 to 4 stand in the same wave"};
  for (const double gauge : {1.0, 2.0, 3.0, 4.0, 6.0, 9.0, 16.0, 22.0}) {
    const Window window{24, wave.until};
    gauges.readings.push_back(highest(gauge, window));
    if (gauge > 4) gauges.readings.push_back(when_highest(gauge, window));
    gauges.readings.push_back(misfit(gauge, window));
  }
  Series runup{.name = "runup",
               .table = "briggs_1995_conical_island_runup",
               .kind = WantedTable::Kind::profile,
               .abscissa = {"angle", "deg", "angle from the front of the island"},
               .quantity = {"R", "m", "largest run-up"},
               .columns = {"R_nthmp", "R_liu"},
               .rows = {{"case", wave.letter}},
               .useful = 0.8,
               .readings = {}};
  for (const double angle : {0, 45, 90, 135, 180}) runup.readings.push_back(at(0, angle, Kind::run_up));
  Experiment one{
      .source = source,
      .parts = {gauges, runup},
      .files = {"briggs_1995_conical_island_a/bathymetry.asc", wave.table + "/gauges.csv", wave.table + "/paddle.csv"},
      .model = "dispersive shallow water in plan"};
  if (values.tier() != Tier::quick) {
    one.compute = compute;
    one.misses = misses(wave);
  }
  return one;
}

}  // namespace

Case island_gauges() {
  Case c;
  c.title = "A solitary wave around a conical island: gauges and run-up";
  c.source = source;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      choice("wave", std::string("A"), {"A", "B", "C"}, "the wave: 0.045, 0.09 or 0.18 depths high"),
      real("spacing", 0.25, "m", {0.2, 0.5}, "of the columns along the walls of the basin, where the model computes")};
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases::island_gauges
