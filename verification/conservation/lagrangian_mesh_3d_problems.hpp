/// Motions of the hexahedral Lagrangian mesh on which conservation, accuracy and symmetries are tried.
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/polynomial_bottom.hpp"

namespace seiche::verification {

using HexahedralProblem = MechanicalProblem<lagrangian_mesh_3d::Model, lagrangian_mesh_3d::Mesh,
                                            lagrangian_mesh_3d::Velocity, lagrangian_mesh_3d::Settings>;

/// Nodes off the boundary moved at random along each axis by up to `part` [m].
inline lagrangian_mesh_3d::Mesh jittered(lagrangian_mesh_3d::Mesh mesh, double part, unsigned seed) {
  std::minstd_rand random(seed);
  std::uniform_real_distribution<double> uniform(-part, part);
  for (std::size_t l = 1; l < mesh.layers; ++l) {
    for (std::size_t j = 1; j < mesh.plan.rows; ++j) {
      for (std::size_t i = 1; i < mesh.plan.columns; ++i) {
        const std::size_t k = mesh.node(i, j, l);
        mesh.x[k] += uniform(random);
        mesh.y[k] += uniform(random);
        mesh.z[k] += uniform(random);
      }
    }
  }
  return mesh;
}

inline const plan_lattice::Sides free_sides{plan_lattice::FreeSide{}, plan_lattice::FreeSide{},
                                            plan_lattice::FreeSide{}, plan_lattice::FreeSide{}};

/// Body of 6 x 5 x 4 cells in [-1, 1]^3 without gravity that nothing holds, sheared, bent and turned by its velocity.
inline HexahedralProblem moving_body(lagrangian_mesh_3d::Settings settings = {}) {
  settings.gravity = 0;
  lagrangian_mesh_3d::Layer layer{.begin = -1, .end = 1, .south = -1, .north = 1, .columns = 6, .rows = 5, .layers = 4};
  layer.elevation = [](double, double) { return 1.0; };
  layer.sides = free_sides;
  lagrangian_mesh_3d::Mesh box = layer_mesh(layer);
  box.free_bottom = true;
  const auto moving = [](lagrangian_mesh_3d::Place r) {
    return lagrangian_mesh_3d::Vector{0.4 * r.x - 0.7 * r.y + 0.1 * std::sin(2 * r.z) + 0.3,
                                      0.5 * r.x - 0.1 * r.y + 0.2 * r.z + 0.1 * std::cos(3 * r.x) - 0.2,
                                      -0.3 * r.z + 0.2 * r.x * r.y + 0.1};
  };
  return HexahedralProblem(jittered(std::move(box), 0.03, 1), moving, settings);
}

/// Water 1 deep on a level bottom under gravity, 12 x 12 x 2 cells of 0.5, that no side holds: it spreads and turns.
inline HexahedralProblem spreading_water(lagrangian_mesh_3d::Settings settings = {}) {
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  lagrangian_mesh_3d::Layer layer{.begin = -3, .end = 3, .south = -3, .north = 3};
  layer.columns = layer.rows = 12;
  layer.layers = 2;
  layer.sides = free_sides;
  const auto turning = [&](lagrangian_mesh_3d::Place r) {
    return lagrangian_mesh_3d::Vector{0.3 - 0.1 * r.y + uniform(random), 0.2 + 0.1 * r.x + uniform(random),
                                      uniform(random)};
  };
  return HexahedralProblem(jittered(layer_mesh(layer), 0.04, 2), turning, settings);
}

/// Bottom under 0 <= x <= 6, 0 <= y <= 4, between 1 and 0.5 deep, bent along both axes.
inline std::shared_ptr<const PlanBottom> uneven_bottom() {
  return polynomial_bottom({{-1, 0, 0}, {0.06, 1, 0}, {0.02, 0, 1}, {0.01, 1, 1}, {-0.004, 2, 0}, {0.001, 1, 2}});
}

/// A hump of 0.1 over it, 12 x 8 x 3 cells of half a depth, between three walls and one that is oblique.
inline lagrangian_mesh_3d::Mesh hump_over_bottom() {
  lagrangian_mesh_3d::Layer layer{.end = 6, .north = 4, .columns = 12, .rows = 8, .layers = 3};
  layer.elevation = [](double x, double y) { return 0.1 * std::exp(-0.6 * ((x - 2) * (x - 2) + (y - 1) * (y - 1))); };
  layer.south_wall = [](double x) { return 0.1 * x; };
  layer.bottom = uneven_bottom();
  return layer_mesh(layer);
}

/// Largest distances so far of its nodes from the bottom, and of those beside the oblique wall from it.
class OffTheBottom {
 public:
  explicit OffTheBottom(const HexahedralProblem& problem)
      : plan_(problem.model.mesh().plan), nodes_(problem.model.nodes().size()) {}

  void operator()(const mechanics::State& state) {
    for (std::size_t k = 0; k < plan_.nodes(); ++k) {
      const double x = state.q[k], y = state.q[nodes_ + k];
      bottom.add(state.q[2 * nodes_ + k] - bottom_->slope(x, y).elevation);
      if (k <= plan_.columns) wall.add(y - 0.1 * x);
    }
  }

  Worst bottom, wall;

 private:
  std::shared_ptr<const PlanBottom> bottom_ = uneven_bottom();
  plan_lattice::Shape plan_;
  std::size_t nodes_;
};

/// A hump of 0.3 in a box 10 x 10 depths, 20 x 20 x 2 cells; its walls at x, y = 0 mirror it.
inline lagrangian_mesh_3d::Mesh hump_in_box() {
  const auto hump = [](double x, double y) { return 0.3 * std::exp(-0.3 * (x * x + y * y)); };
  return lagrangian_mesh_3d::layer_mesh(
      {.end = 10, .north = 10, .columns = 20, .rows = 20, .layers = 2, .elevation = hump});
}

}  // namespace seiche::verification
