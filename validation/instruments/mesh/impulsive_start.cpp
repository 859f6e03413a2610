#include "validation/instruments/mesh/impulsive_start.hpp"

#include <array>

#include "seiche/mechanics/start.hpp"

namespace seiche::validation {

std::vector<Point> impulsive_start(const lagrangian_mesh_2d::Mesh& mesh,
                                   const std::function<double(double x)>& potential) {
  // Without gravity the surface pressure is the only force, and a kick of length one its impulse.
  // Once, so directly: what it leaves of the rates of areas is round-off.
  lagrangian_mesh_2d::Model model(mesh, {.gravity = 0, .solver = linear::SolverMethod::banded, .tolerance = 1e-13},
                                  {.surface_pressure = [&](double x, double) { return -potential(x); }});
  mechanics::State state = model.state();
  model.linearise({.begin = 0, .length = 0}, state.q);
  model.kick(1, state.u);
  mechanics::Start(model).project(state);
  std::vector<Point> velocities(mesh.nodes());
  for (std::size_t k = 0; k < mesh.nodes(); ++k) velocities[k] = {state.u[k], state.u[mesh.nodes() + k]};
  return velocities;
}

namespace {

/// int N_a dr x dr of the corners of a patch.
std::array<Vector3, 4> corner_areas(const std::array<Vector3, 4>& r) {
  std::array<Vector3, 4> normal{};
  for (std::size_t a = 0; a < 4; ++a) normal[a] = cross(r[(a + 1) % 4] - r[a], r[(a + 3) % 4] - r[a]);
  std::array<Vector3, 4> area{};
  for (std::size_t a = 0; a < 4; ++a) {
    area[a] = (4 * normal[a] + 2 * (normal[(a + 1) % 4] + normal[(a + 3) % 4]) + normal[(a + 2) % 4]) / 36;
  }
  return area;
}

}  // namespace

std::vector<Vector3> impulsive_start(const lagrangian_mesh_3d::Mesh& mesh,
                                     const std::function<double(double x, double y)>& potential) {
  lagrangian_mesh_3d::Model model(mesh, {.gravity = 0, .tolerance = 1e-13});
  const std::size_t n = mesh.nodes();
  std::vector<Vector3> impulse(n);
  const std::size_t top = mesh.layers * mesh.plan.nodes();
  for (std::size_t cell = 0; cell < mesh.plan.cells(); ++cell) {
    auto nodes = mesh.plan.corners(cell);
    std::array<Vector3, 4> r{};
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
    for (std::size_t a = 0; a < 4; ++a) impulse[nodes[a]] = impulse[nodes[a]] + phi * area[a];
  }
  const std::vector<double>& mass = model.nodes().mass();
  std::vector<Vector3> velocities(n);
  for (std::size_t k = top; k < n; ++k) velocities[k] = impulse[k] / mass[k];
  mechanics::State state = model.state(velocities);
  mechanics::Start(model).project(state);
  for (std::size_t k = 0; k < n; ++k) velocities[k] = vector_at(state.u, k);
  return velocities;
}

}  // namespace seiche::validation
