/*
Water of a broken dam, 0.3 m high, runs over a dry floor and hits a wall 1.01 m away (Lobovsky and others). The
pressure 0.015 m above the floor was recorded in about a hundred repeats.

**What is compared.** Impulse of the impact, the plateau after it, and the root mean square difference from the
median; the band of the repeats is the uncertainty. One shift of time, of the impact, is fitted and reported: a gate
that takes 0.1 s to go delays it. The case scores others.

**What to look at.** The median of single peaks that come at different times is lower than each of them: no peak is
asked for. Average a computed pressure over 5 ms and over the sensor's face of 4 mm.
*/
#include "validation/laboratory/laboratory_case.hpp"

namespace seiche::validation::cases {
namespace {

using namespace laboratory;

const std::string source =
    "L. Lobovsky, E. Botia-Vera, F. Castellana, J. Mas-Soler, A. Souto-Iglesias, J. Fluids Struct. 48 (2014) 407-434";

Experiment experiment(const Values& /*values*/) {
  return {
      .source = source,
      .parts = {{.name = "pressure",
                 .table = "lobovsky_2014_dam_break_pressure",
                 .abscissa = {"T", "1", "time t sqrt(g/H) since the gate starts"},
                 .quantity = {"p", "1", "pressure over rho g H on the wall"},
                 .band = {"p_low", "p_high"},
                 .clock = Clock{.group = 0, .range = 0.4, .window = {2.3, 3.2}},
                 .readings = {impulse(0, {2.46, 4.0}), mean(0, {3.4, 5.4}, Kind::pressure), misfit(0, {2.6, 5.5})}}}};
}

}  // namespace

Case dam_break_wall_pressure() {
  Case c;
  c.title = "Pressure of a broken dam on a wall, with its repeats";
  c.source = source;
  set_laboratory<experiment>(c);
  return c;
}

}  // namespace seiche::validation::cases
