/*
Water of a dam break through a gap runs over a thin layer of water against an oblique building (Soares-Frazao and Zech
2007).

**What is compared.** Depth at six gauges: arrival time and means over two seconds; mean velocity along the channel at
five gauges. The case accepts external results.

**What to look at.** Gauges 2 and 5, near a bore, discriminate between friction values and resolutions more than between
models. The gauges read 0 at the initial water layer of 0.02 m.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::isolated_building {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  const Column gauge{"gauge", "1", "number"};
  const Column time{"t", "s", "time since the gate opens"};
  Series depths{.name = "depths",
                .table = "soares_frazao_zech_2007_isolated_building",
                .group = gauge,
                .abscissa = time,
                .quantity = {"h", "m", "depth of the water"},
                .telling = 0.4};
  for (double at = 1; at <= 6; ++at) {
    if (at < 6) depths.readings.push_back(arrival(at, 0.03, {0, 6}));
    depths.read({mean(at, {5, 7}), mean(at, {10, 12}), mean(at, {20, 22})});
  }
  Series velocity{.name = "velocity",
                  .table = "soares_frazao_zech_2007_isolated_building_velocity",
                  .group = gauge,
                  .abscissa = time,
                  .quantity = {"u", "m/s", "velocity along the channel"}};
  for (const double at : {1, 2, 4}) {
    velocity.read({mean(at, {5, 7}, Kind::velocity), mean(at, {10, 12}, Kind::velocity)});
  }
  const std::string folder = "soares_frazao_zech_2007_isolated_building/";
  return {.source = "S. Soares-Frazao, Y. Zech, J. Hydraul. Res. 45, extra issue (2007) 27-36",
          .parts = {depths, velocity},
          .files = {folder + "bathymetry.asc", folder + "building.stl", folder + "gauges.csv"}};
}

void isolated_building(Case& c) {
  set_laboratory<experiment>(c, "Dam break against an oblique building");
}

}  // namespace seiche::validation::cases::isolated_building
