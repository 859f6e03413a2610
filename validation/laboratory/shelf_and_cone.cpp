/*
A solitary wave of H/h = 0.5 breaks on a triangular shelf with a conical island (Lynett and others 2019; NTHMP currents
problem 5).

**What is compared.** Surface elevation at nine gauges: maximum and rms difference; velocity in the wave direction at
three probes, with the standard deviation of the repeats. One time shift is fitted at gauge 1. The case accepts external
results.

**What to look at.** Transverse velocities, zero on the axis by symmetry, are not zero there in the experiment, and are
not scored.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::shelf_and_cone {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  const Column time{"t", "s", "time of the experiment"};
  Series gauges{.table = "lynett_2010_shelf_cone",
                .group = Column{"gauge", "1", "number"},
                .abscissa = time,
                .telling = 1.5,
                .origin = 3.62,
                .clock = Clock{.group = 1, .range = 1.5, .window = {1, 6}}};
  for (double gauge = 1; gauge <= 9; ++gauge) {
    const Window window{1.5, 20};
    gauges.read({highest(gauge, window), misfit(gauge, window)});
    if (gauge == 2 || gauge == 3 || gauge == 5) gauges.readings.push_back(when_highest(gauge, window));
  }
  Series velocity{.name = "velocity",
                  .table = "lynett_2010_shelf_cone_velocity",
                  .group = Column{"probe", "1", "1 to 3 for A, B, C"},
                  .abscissa = time,
                  .quantity = {"u", "m/s", "velocity along the wave's direction"},
                  .spread = "u_rms"};
  for (const double probe : {1, 2, 3}) {
    velocity.read({highest(probe, {0, 20}, Kind::velocity), misfit(probe, {0, 20})});
  }
  return {.source =
              "P. J. Lynett, D. Swigler, H. El Safty, L. Montoya, A. S. Keen, S. Son, P. Higuera, J. Waterway Port "
              "Coastal Ocean Eng. 145 (2019) 04019024",
          .parts = {gauges, velocity},
          .files = {"lynett_2010_shelf_cone/bathymetry.asc", "lynett_2010_shelf_cone/gauges.csv"}};
}

void shelf_and_cone(Case& c) {
  set_laboratory<experiment>(c, "A solitary wave on a shelf with a conical island");
}

}  // namespace seiche::validation::cases::shelf_and_cone
