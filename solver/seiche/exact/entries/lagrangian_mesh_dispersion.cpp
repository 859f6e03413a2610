#include "seiche/exact/lagrangian_mesh_dispersion.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/law_in_time.hpp"

namespace seiche::exact {

ExactSolution lagrangian_mesh_dispersion_entry() {
  return law_in_time_entry<LagrangianMeshDispersion>(
      "lagrangian_mesh_dispersion", "Dispersion of Frank's two-dimensional Lagrangian mesh, and with a time step",
      {{"column_width", "m", 0.25, 1e-9, 1e6, "width of a column of cells"},
       {"rows", "1", 4, 1, 1e4, "rows of cells"},
       {"tuned", "1", 0, 0, 1, "vertical inertia of surface nodes", {"nodal", "tuned"}}},
      [](const Values& p) {
        const double rows = p.at("rows");
        if (rows != std::floor(rows)) {
          throw std::invalid_argument(fmt::format("rows = {:g} is out of range: must be a whole number", rows));
        }
        return LagrangianMeshDispersion(p.at("gravity"), p.at("depth"), p.at("column_width"),
                                        static_cast<std::size_t>(rows),
                                        p.at("tuned") == 0 ? SurfaceInertia::nodal : SurfaceInertia::tuned);
      });
}

}  // namespace seiche::exact
