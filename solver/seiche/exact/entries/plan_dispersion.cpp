#include "seiche/exact/plan_dispersion.hpp"

#include "seiche/exact/entries/directed_law.hpp"
#include "seiche/exact/entries/entries.hpp"

namespace seiche::exact {

ExactSolution plan_dispersion_entry() {
  using Directed = DirectedLaw<PlanDispersion>;
  return law_in_time_entry<Directed>(
      "plan_dispersion", "Dispersion of the discrete dispersive shallow water in plan, and with a time step",
      {direction_parameter(),
       {"spacing_x", "m", 0.5, 1e-9, 1e6, "distance of the markers along x"},
       {"spacing_y", "m", 0.5, 1e-9, 1e6, "distance of the markers along y"},
       {"alpha", "1", 1.0 / 3, 0, 10, "factor of the vertical kinetic energy"}},
      [](const Values& p) {
        return Directed(
            PlanDispersion(p.at("gravity"), p.at("depth"), p.at("spacing_x"), p.at("spacing_y"), p.at("alpha")), p);
      });
}

}  // namespace seiche::exact
