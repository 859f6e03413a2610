#include "seiche/models/lagrangian_mesh_3d/layer.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

double part(double begin, double end, std::size_t index, std::size_t count) {
  const double fraction = static_cast<double>(index) / static_cast<double>(count);
  return index == count ? end : begin + (end - begin) * fraction;
}

void require_ascending(const char* first, double begin, const char* last, double end) {
  require_finite(first, begin);
  require_finite(last, end);
  require_that(end > begin, "{} = {:g}; allowed: above {} = {:g}", last, end, first, begin);
}

void require_cells(Shape plan, std::size_t layers) {
  require_at_least("columns", static_cast<long>(plan.columns), 1);
  require_at_least("rows", static_cast<long>(plan.rows), 1);
  require_at_least("layers", static_cast<long>(layers), 1);
}

}  // namespace

Mesh layer_mesh(const Layer& layer) {
  require_ascending("begin", layer.begin, "end", layer.end);
  if (!layer.south_wall) require_ascending("south", layer.south, "north", layer.north);
  require_positive("depth", layer.depth);
  Mesh mesh{.plan = {layer.columns, layer.rows},
            .layers = layer.layers,
            .x = {},
            .y = {},
            .z = {},
            .sides = layer.sides,
            .bottom = layer.bottom};
  require_cells(mesh.plan, mesh.layers);
  for (std::size_t l = 0; l <= layer.layers; ++l) {
    for (std::size_t j = 0; j <= layer.rows; ++j) {
      for (std::size_t i = 0; i <= layer.columns; ++i) {
        const double x = part(layer.begin, layer.end, i, layer.columns);
        const double south = layer.south_wall ? layer.south_wall(x) : layer.south;
        const double y = part(south, layer.north, j, layer.rows);
        const double surface = layer.elevation ? layer.elevation(x, y) : 0.0;
        const double bottom = layer.bottom ? layer.bottom->slope(x, y).elevation : -layer.depth;
        require_that(surface > bottom && south < layer.north,
                     "elevation {:g} and south side {:g} at x = {:g}, y = {:g}; allowed: above the bottom {:g}, "
                     "below north = {:g}",
                     surface, south, x, y, bottom, layer.north);
        mesh.x.push_back(x);
        mesh.y.push_back(y);
        mesh.z.push_back(part(bottom, surface, l, layer.layers));
      }
    }
  }
  return mesh;
}

Mesh free_box(const Box& box) {
  require_positive("side along x", box.sides.x);
  require_positive("side along y", box.sides.y);
  require_positive("side along z", box.sides.z);
  require_cells(box.plan, box.layers);
  using plan_lattice::FreeSide;
  Mesh mesh{.plan = box.plan,
            .layers = box.layers,
            .x = {},
            .y = {},
            .z = {},
            .sides = {FreeSide{}, FreeSide{}, FreeSide{}, FreeSide{}},
            .free_bottom = true};
  for (std::size_t l = 0; l <= box.layers; ++l) {
    for (std::size_t j = 0; j <= box.plan.rows; ++j) {
      for (std::size_t i = 0; i <= box.plan.columns; ++i) {
        mesh.x.push_back(part(box.corner.x, box.corner.x + box.sides.x, i, box.plan.columns));
        mesh.y.push_back(part(box.corner.y, box.corner.y + box.sides.y, j, box.plan.rows));
        mesh.z.push_back(part(box.corner.z, box.corner.z + box.sides.z, l, box.layers));
      }
    }
  }
  return mesh;
}

}  // namespace seiche::lagrangian_mesh_3d
