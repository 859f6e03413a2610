/*
The tsunami of 1993 in the valley of Monai, in a 1:400 model (Matsuyama and Tanaka 2001; NTHMP benchmark problem 7).

**What is compared.** Surface elevation at three gauges: maximum, its time, and the rms difference; maximum run-up at
three positions, from six repeats. The level just before arrival is removed. The case accepts external results. The
template names the files of the set-up: bathymetry, and the elevation at x = 0 that drives the flow.

**What to look at.** Levels at the gauges deviated by 2 mm before the wave arrived. Run-up differs by 4 to 10 % between
repeats of the same wave.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::monai_valley {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  Series gauges{.table = "matsuyama_tanaka_2001_monai_valley",
                .group = Column{"gauge", "1", "number"},
                .abscissa = {"t", "s", "time of the incident wave"},
                .still = Window{10, 12},
                .telling = 1.5};
  for (const double gauge : {5, 7, 9}) {
    gauges.read({highest(gauge, {12, 24}), when_highest(gauge, {12, 24}), misfit(gauge, {12, 24})});
  }
  const Series runup{.name = "runup",
                     .table = "matsuyama_tanaka_2001_monai_valley_runup",
                     .kind = WantedTable::Kind::scalars,
                     .group = Column{"place", "1", "number: 1 is the valley's end"},
                     .abscissa = {"place", "1", "the same"},
                     .quantity = {"R", "m", "highest run-up"},
                     .readings = {at(1, 1, Kind::run_up), at(2, 2, Kind::run_up), at(3, 3, Kind::run_up)}};
  const std::string folder = "matsuyama_tanaka_2001_monai_valley/";
  return {
      .source =
          "M. Matsuyama, H. Tanaka, Proc. Int. Tsunami Symposium (2001) 879-889; P. L.-F. Liu, H. Yeh, C. Synolakis "
          "(eds.), Advanced Numerical Models for Simulating Tsunami Waves and Runup, World Scientific (2008) 223-230",
      .parts = {gauges, runup},
      .files = {folder + "bathymetry.asc", folder + "incident.csv", folder + "gauges.csv"}};
}

void monai_valley(Case& c) {
  set_laboratory<experiment>(c, "The tsunami of 1993 in the valley of Monai");
}

}  // namespace seiche::validation::cases::monai_valley
