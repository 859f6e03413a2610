#include "seiche/models/lagrangian_mesh_2d/impulsive_start.hpp"

#include "seiche/models/lagrangian_mesh_2d/integrators.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"

namespace seiche::lagrangian_mesh_2d {

std::vector<Point> impulsive_start(const Mesh& mesh, const std::function<double(double x)>& potential) {
  // Without gravity the surface pressure is the only force, and a kick of length one its impulse.
  // Once, so directly: what it leaves of the rates of areas is round-off.
  Model model(mesh, {.gravity = 0, .solver = linear::SolverMethod::banded, .tolerance = 1e-13},
              {.surface_pressure = [&](double x, double) { return -potential(x); }});
  mechanics::State state = model.state();
  model.linearise({.begin = 0, .length = 0}, state.q);
  model.kick(1, state.u);
  mechanics::Start(model).project(state);
  std::vector<Point> velocities(mesh.nodes());
  for (std::size_t k = 0; k < mesh.nodes(); ++k) velocities[k] = {state.u[k], state.u[mesh.nodes() + k]};
  return velocities;
}

}  // namespace seiche::lagrangian_mesh_2d
