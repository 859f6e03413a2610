/// Motions of the two-dimensional Lagrangian mesh on which conservation, accuracy and symmetries are tried.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/integrators.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "verification/conservation/mechanical_problem.hpp"

namespace seiche::verification {

using MeshProblem = MechanicalProblem<lagrangian_mesh_2d::Model, lagrangian_mesh_2d::Mesh, std::function<Point(Point)>,
                                      lagrangian_mesh_2d::Settings>;

inline Point turned(Point r, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * r.x - s * r.y, s * r.x + c * r.y};
}

/// Free square [-1, 1]^2 of 8 x 8 cells without gravity that moves with u = (0.4 x - 0.7 y + 0.1 sin 2y + 0.3, 0.5 x -
/// 0.4 y + 0.1 cos 3x - 0.2), turned by `angle` about the origin and then shifted along both axes.
inline MeshProblem moving_patch(double angle = 0, double shift = 0) {
  lagrangian_mesh_2d::Mesh mesh = lagrangian_mesh_2d::free_patch(8, 8, {-1, -1}, {1, 1});
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Point r = turned({mesh.x[k], mesh.y[k]}, angle);
    mesh.x[k] = r.x + shift;
    mesh.y[k] = r.y + shift;
  }
  const auto velocity = [=](Point place) {
    const auto [x, y] = turned({place.x - shift, place.y - shift}, -angle);
    return turned({0.4 * x - 0.7 * y + 0.1 * std::sin(2 * y) + 0.3, 0.5 * x - 0.4 * y + 0.1 * std::cos(3 * x) - 0.2},
                  angle);
  };
  return MeshProblem(std::move(mesh), velocity, {.gravity = 0});
}

inline double cosine_elevation(double x) {
  return 0.1 * std::cos(std::numbers::pi * x / 6);
}

/// Water at rest in a box 6 depths long, 16 x 4 cells, its surface half a wave of height 0.1 cos(pi x/6).
inline MeshProblem sloshing(lagrangian_mesh_2d::Settings settings = {}) {
  return MeshProblem(
      lagrangian_mesh_2d::layer_mesh({.begin = 0, .end = 6, .columns = 16, .rows = 4, .elevation = cosine_elevation}),
      {}, settings);
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

}  // namespace seiche::verification
