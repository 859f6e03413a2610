#include "seiche/exact/frank_dispersion.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/law_in_time.hpp"

namespace seiche::exact {

ExactSolution frank_dispersion_entry() {
  return law_in_time_entry<FrankDispersion>(
      "frank_dispersion", "Dispersion of Frank's discrete dispersive shallow water, formula (13), and with a time step",
      {{"spacing", "m", 0.1, 1e-9, 1e6, "distance of the markers"},
       {"alpha", "1", 1.0 / 3, 0, 10, "factor of the vertical kinetic energy"},
       {"beta", "1", 1.0 / 3, -10, 10, "factor of the potential energy of a cell's slope"},
       {"gamma", "1", 0, -10, 10, "factor of an added potential energy of slopes"}},
      [](const Values& p) {
        return FrankDispersion(p.at("gravity"), p.at("depth"), p.at("spacing"),
                               {.alpha = p.at("alpha"), .beta = p.at("beta"), .gamma = p.at("gamma")});
      });
}

}  // namespace seiche::exact
