#include "seiche/models/lagrangian_mesh_3d/flow.hpp"

#include <stdexcept>
#include <utility>

#include "seiche/models/lagrangian_mesh_3d/stability.hpp"

namespace seiche::lagrangian_mesh_3d {

namespace {

Window over_level_bottom(Window window, const Model& model) {
  if (window.reach && model.mesh().bottom) {
    throw std::invalid_argument("a moving window over an uneven bottom; allowed: over a level one");
  }
  return window;
}

}  // namespace

Flow::Flow(Mesh mesh, const Velocity& velocity, Scheme scheme, Settings settings, Window window, bool smooth_start,
           Forcing forcing)
    : Flow(std::make_unique<Model>(std::move(mesh), settings, std::move(forcing)), velocity, scheme, std::move(window),
           smooth_start) {}

Flow::Flow(std::unique_ptr<Model>&& model, const Velocity& velocity, Scheme scheme, Window window, bool smooth_start)
    : LatticeFlow(std::move(model), model->state(velocity), model->mesh().plan, model->mesh().sides,
                  {.scheme = scheme,
                   .window = over_level_bottom(std::move(window), *model),
                   .stable_step = surely_stable_step(*model),
                   .smooth_start = smooth_start && model->nodes().driven().empty()}) {}

}  // namespace seiche::lagrangian_mesh_3d

template class seiche::plan_lattice::LatticeFlow<seiche::lagrangian_mesh_3d::Model>;
