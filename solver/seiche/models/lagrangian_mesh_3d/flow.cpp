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

namespace {

/// int N_a dr x dr of the corners of a patch.
std::array<Vector, 4> corner_areas(const std::array<Vector, 4>& r) {
  std::array<Vector, 4> normal{};
  for (std::size_t a = 0; a < 4; ++a) {
    normal[a] = cross(r[(a + 1) % 4] - r[a], r[(a + 3) % 4] - r[a]);
  }
  std::array<Vector, 4> area{};
  for (std::size_t a = 0; a < 4; ++a) {
    area[a] = (4 * normal[a] + 2 * (normal[(a + 1) % 4] + normal[(a + 3) % 4]) + normal[(a + 2) % 4]) / 36;
  }
  return area;
}

}  // namespace

std::vector<Vector> impulsive_start(const Mesh& mesh, const std::function<double(double x, double y)>& potential) {
  Model model(mesh, {.gravity = 0, .tolerance = 1e-13});
  const std::size_t n = mesh.nodes();
  std::vector<Vector> impulse(n);
  const std::size_t top = mesh.layers * mesh.plan.nodes();
  for (std::size_t cell = 0; cell < mesh.plan.cells(); ++cell) {
    auto nodes = mesh.plan.corners(cell);
    std::array<Vector, 4> r{};
    double x = 0;
    double y = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      nodes[a] += top;
      r[a] = {mesh.x[nodes[a]], mesh.y[nodes[a]], mesh.z[nodes[a]]};
      x += r[a].x / 4;
      y += r[a].y / 4;
    }
    const double phi = potential(x, y);
    const auto area = corner_areas(r);
    for (std::size_t a = 0; a < 4; ++a) {
      impulse[nodes[a]] = impulse[nodes[a]] + phi * area[a];
    }
  }
  const std::vector<double>& mass = model.nodes().mass();
  std::vector<Vector> velocities(n);
  for (std::size_t k = top; k < n; ++k) {
    velocities[k] = impulse[k] / mass[k];
  }
  mechanics::State state = model.state(velocities);
  mechanics::Start(model).project(state);
  for (std::size_t k = 0; k < n; ++k) velocities[k] = vector_at(state.u, k);
  return velocities;
}

namespace {

void require_ascending(const char* first, double begin, const char* last, double end) {
  require_finite(first, begin);
  require_finite(last, end);
  require_that(end > begin, "{} = {:g}; allowed: above {} = {:g}", last, end, first, begin);
}

}  // namespace

Mesh layer_mesh(const Layer& layer) {
  using plan_lattice::equally_spaced;
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
