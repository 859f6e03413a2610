/*
A solitary wave around a conical island in 0.32 m of water (Briggs and others; NTHMP benchmark problem 6): waves A, B
and C, 0.045, 0.09 and 0.18 depths high.

**What is compared.** Surface elevation at four gauges before the island and four around it: highest value, when, and
the root mean square difference; run-up around the island. Levels before arrival are removed, and one shift of time is
fitted at gauge 3, before the island. The case scores others; the plan model's run-up is judged in `conical_island`.

**What to look at.** Two distributions of the same run-up differ by up to 1.9: the mean of both is asked for, and half
of their distance is an uncertainty. The records show a wave B of 0.087 depths, not the 0.096 that is stated.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source =
    "M. J. Briggs, C. E. Synolakis, G. S. Harkins, D. R. Green, Pure Appl. Geophys. 144 (1995) 569-593; P. L.-F. Liu "
    "et "
    "al., J. Fluid Mech. 302 (1995) 259-285";

struct Wave {
  std::string table;
  double letter, passes, until;
};

Wave wave_of(const Values& values) {
  if (values.text("wave") == "A") return {"briggs_1995_conical_island_a", 1, 28.80, 36};
  if (values.text("wave") == "B") return {"briggs_1995_conical_island_b", 2, 28.30, 35};
  return {"briggs_1995_conical_island_c", 3, 27.80, 35};
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
  return {
      .source = source,
      .parts = {gauges, runup},
      .files = {"briggs_1995_conical_island_a/bathymetry.asc", wave.table + "/gauges.csv", wave.table + "/paddle.csv"}};
}

}  // namespace

Case island_gauges() {
  Case c;
  c.title = "A solitary wave around a conical island: gauges and run-up";
  c.source = source;
  c.parameters = {choice("wave", std::string("A"), {"A", "B", "C"}, "the wave: 0.045, 0.09 or 0.18 depths high")};
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
