/// Motions of the two-dimensional Lagrangian mesh on which conservation, accuracy and symmetries are tried.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "verification/conservation/mechanical_problem.hpp"

namespace seiche::verification {

using MeshProblem = MechanicalProblem<lagrangian_mesh_2d::Model, lagrangian_mesh_2d::Mesh, std::function<Point(Point)>,
                                      lagrangian_mesh_2d::Settings>;

/// Free square [-1, 1]^2 of 8 x 8 cells without gravity that is stirred.
inline MeshProblem moving_patch() {
  return MeshProblem(lagrangian_mesh_2d::free_patch(8, 8, {-1, -1}, {1, 1}), stirring, {.gravity = 0});
}

inline double cosine_elevation(double x) {
  return 0.1 * std::cos(std::numbers::pi * x / 6);
}

/// Water at rest in a box 6 depths long, 16 x 4 cells, its surface half a wave of height 0.1 cos(pi x/6).
inline MeshProblem sloshing(lagrangian_mesh_2d::Settings settings = {}) {
  return MeshProblem(
      lagrangian_mesh_2d::layer_mesh({.end = 6, .columns = 16, .rows = 4, .elevation = cosine_elevation}), {},
      settings);
}

/// A bump of height 0.3 in the middle of a bottom at -1, over [0, 6].
inline std::shared_ptr<const GraphCurve> bump() {
  const auto part = [](double x) { return (x - 3) / 0.8; };
  return std::make_shared<GraphCurve>([=](double x) { return -1 + 0.3 * std::exp(-part(x) * part(x)); },
                                      [=](double x) { return -0.75 * part(x) * std::exp(-part(x) * part(x)); },
                                      [=](double x) {
                                        const double square = part(x) * part(x);
                                        return 0.9375 * (2 * square - 1) * std::exp(-square);
                                      },
                                      0, 6, 60);
}

/// Still water up to a wall of slope 1 whose curve ends 0.05 above its level.
inline lagrangian_mesh_2d::Mesh water_at_short_wall() {
  auto mesh = lagrangian_mesh_2d::layer_mesh_with_slope({.end = 4, .columns = 16, .rows = 4}, 1);
  const auto height = [](double x) { return x - 5; };
  const auto one = [](double) { return 1.0; };
  const auto zero = [](double) { return 0.0; };
  mesh.sides.right = lagrangian_mesh_2d::Wall{std::make_shared<GraphCurve>(height, one, zero, 3.9, 5.05, 8)};
  return mesh;
}

constexpr double wave_energy = 0.015;  ///< of a surface 0.1 cos(kx) over 6 depths, (1/4) 0.1^2 6

/// Water that sloshes between walls of all kinds: what they are, and the water.
inline std::vector<std::pair<std::string, MeshProblem (*)()>> basins() {
  using namespace lagrangian_mesh_2d;
  static const auto finer = [](std::shared_ptr<const GraphCurve> bottom = {}) {
    return Layer{.end = 6, .columns = 24, .rows = 4, .elevation = cosine_elevation, .bottom = std::move(bottom)};
  };
  return {{"vertical walls, level bottom", [] { return sloshing(); }},
          {"an inclined wall", [] { return MeshProblem(layer_mesh_with_slope(finer(), 1)); }},
          {"a bump on the bottom", [] { return MeshProblem(layer_mesh(finer(bump()))); }},
          {"vertical walls, with the hourglass potential", [] { return sloshing({.hourglass = 0.3}); }}};
}

}  // namespace seiche::verification
