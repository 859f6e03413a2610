#include "seiche/exact/hexahedral_dispersion.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/entries/directed_law.hpp"
#include "seiche/exact/entries/entries.hpp"

namespace seiche::exact {

ExactSolution hexahedral_dispersion_entry() {
  using Directed = DirectedLaw<HexahedralDispersion>;
  return law_in_time_entry<Directed>(
      "hexahedral_dispersion", "Dispersion of Frank's three-dimensional Lagrangian mesh, and with a time step",
      {direction_parameter(),
       {"spacing_x", "m", 0.5, 1e-9, 1e6, "side of a cell along x"},
       {"spacing_y", "m", 0.5, 1e-9, 1e6, "side of a cell along y"},
       {"layers", "1", 2, 1, 1e4, "layers of cells"},
       {"tuned", "1", 0, 0, 1, "vertical inertia of surface nodes", {"nodal", "tuned"}}},
      [](const Values& p) {
        const double layers = p.at("layers");
        if (layers != std::floor(layers)) {
          throw std::invalid_argument(fmt::format("layers = {:g} is out of range: must be a whole number", layers));
        }
        return Directed(HexahedralDispersion(p.at("gravity"), p.at("depth"), p.at("spacing_x"), p.at("spacing_y"),
                                             static_cast<std::size_t>(layers),
                                             p.at("tuned") == 0 ? SurfaceInertia::nodal : SurfaceInertia::tuned),
                        p);
      });
}

}  // namespace seiche::exact
