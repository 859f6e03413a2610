/*
A dam break hits a box in an open tank (Kleefsman and others 2005; SPHERIC test 2).

**What is compared.** Water height at four positions: arrival time and mean up to the return wave. Pressure on the face
of the box: arrival time and impulse up to 1 s. The case accepts external results.

**What to look at.** The distributed file exchanges two of the heights against the drawing; positions follow here from
arrival times. Pressure peaks are not scored. Broken water contains air, and a wire probe measures its wetted length.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases::dam_break_box {

using namespace laboratory;

Experiment experiment(const Values& /*values*/) {
  const Column time{"t", "s", "time since the door opens"};
  Series heights{
      .name = "heights",
      .table = "kleefsman_2005_dam_break_box",
      .group = Column{"x", "m", "distance from the wall behind the box"},
      .abscissa = time,
      .quantity = {"h", "m", "height of the water"},
      .telling = 0.2,
      .readings = {arrival(1.488, 0.04, {0.05, 1}), arrival(0.992, 0.04, {0.05, 1}), arrival(0.496, 0.04, {0.05, 2})}};
  for (const double x : {0.496, 0.992, 1.488, 2.638}) heights.readings.push_back(mean(x, {0.5, 1.8}));
  for (const double x : {0.992, 2.638}) heights.readings.push_back(misfit(x, {0, 2}));
  Series pressure{.name = "pressure",
                  .table = "kleefsman_2005_dam_break_box_pressure",
                  .group = Column{"probe", "1", "number, 1 to 4 upwards on the face"},
                  .abscissa = time,
                  .quantity = {"p", "Pa", "pressure on the box"},
                  .input = 0.1,
                  .input_reason = "calibration of the probes in aerated water, estimated",
                  .telling = 0.2};
  for (const double probe : {1, 2, 3, 4}) {
    pressure.read({arrival(probe, 1000, {0.1, 1}), impulse(probe, {0.39, 1.0})});
  }
  return {.source =
              "K. M. T. Kleefsman, G. Fekken, A. E. P. Veldman, B. Iwanowski, B. Buchner, J. Comput. Phys. 206 (2005) "
              "363-393",
          .parts = {heights, pressure},
          .files = {"kleefsman_2005_dam_break_box/box.stl"}};
}

void dam_break_box(Case& c) {
  set_laboratory<experiment>(c, "Dam break against a box");
}

}  // namespace seiche::validation::cases::dam_break_box
