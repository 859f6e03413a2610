#include "seiche/models/lagrangian_mesh_3d/flow.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_3d {

Flow::Flow(Mesh mesh, const Velocity& velocity, Scheme scheme, Settings settings, Window window, bool smooth_start,
           Forcing forcing)
    : LatticeFlow(scheme, window) {
  auto model = std::make_unique<Model>(std::move(mesh), settings, std::move(forcing));
  require_that(!window.reach || !model->mesh().bottom,
               "a moving window over an uneven bottom; allowed: over a level one");
  begin_between(model->mesh().sides, model->mesh().plan, std::move(model), model->state(velocity),
                surely_stable_step(*model), smooth_start && model->nodes().driven().empty());
}

Mesh layer_mesh(const Layer& layer) {
  using plan_lattice::equally_spaced;
  plan_lattice::require_ascending("begin", layer.begin, "end", layer.end);
  if (!layer.south_wall) plan_lattice::require_ascending("south", layer.south, "north", layer.north);
  require_positive("depth", layer.depth);
  Mesh mesh{.plan = {layer.columns, layer.rows},
            .layers = layer.layers,
            .x = {},
            .y = {},
            .z = {},
            .sides = layer.sides,
            .bottom = layer.bottom};
  require_at_least("columns", static_cast<long>(layer.columns), 1);
  require_at_least("rows", static_cast<long>(layer.rows), 1);
  require_at_least("layers", static_cast<long>(layer.layers), 1);
  for (std::size_t l = 0; l <= layer.layers; ++l) {
    for (std::size_t j = 0; j <= layer.rows; ++j) {
      for (std::size_t i = 0; i <= layer.columns; ++i) {
        const double x = equally_spaced(layer.begin, layer.end, i, layer.columns);
        const double south = layer.south_wall ? layer.south_wall(x) : layer.south;
        const double y = equally_spaced(south, layer.north, j, layer.rows);
        const double surface = layer.elevation ? layer.elevation(x, y) : 0.0;
        const double bottom = layer.bottom ? layer.bottom->slope(x, y).elevation : -layer.depth;
        require_that(surface > bottom && south < layer.north,
                     "elevation {:g} and south side {:g} at x = {:g}, y = {:g}; allowed: above the bottom {:g}, "
                     "below north = {:g}",
                     surface, south, x, y, bottom, layer.north);
        mesh.x.push_back(x);
        mesh.y.push_back(y);
        mesh.z.push_back(equally_spaced(bottom, surface, l, layer.layers));
      }
    }
  }
  return mesh;
}

}  // namespace seiche::lagrangian_mesh_3d

template class seiche::plan_lattice::LatticeFlow<seiche::lagrangian_mesh_3d::Model>;
