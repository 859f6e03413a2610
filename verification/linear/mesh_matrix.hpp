/// The matrix A = J M^-1 J^T of the pressure equation on a quadrilateral mesh (Frank 1994, ch. 2), smoothly deformed,
/// and what tests of solvers share.
///
/// Rectangular cells before the deformation, rows upwards; every mesh node is displaced along half cosines about two
/// depths long, by at most `amplitude` times the smaller of length and depth. Nodes on the left and right walls move
/// only vertically, on the bottom only horizontally, at the top freely.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Dense>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "verification/noise.hpp"

namespace seiche::verification {

/// @param row_heights  from the bottom up
inline linear::StencilMatrix mesh_matrix(std::size_t columns, double h1, const std::vector<double>& row_heights,
                                         double amplitude) {
  std::vector<double> levels{0};
  for (const double height : row_heights) levels.push_back(levels.back() + height);
  const double length = h1 * static_cast<double>(columns);
  const double depth = levels.back();
  const double a = amplitude * std::min(length, depth);
  const double k = std::numbers::pi / length * std::max(1.0, std::round(length / (2 * depth)));
  const double l = std::numbers::pi / (2 * depth);
  using namespace lagrangian_mesh_2d;
  Mesh mesh{{columns, row_heights.size()}};
  for (const double y : levels) {
    for (std::size_t i = 0; i <= columns; ++i) {
      const double x = h1 * static_cast<double>(i);
      const bool wall = i == 0 || i == columns;
      mesh.x.push_back(wall ? x : x + a * std::sin(k * x) * std::cos(l * y));
      mesh.y.push_back(y + a * std::cos(k * x) * std::sin(l * y));
    }
  }
  mesh.sides = {vertical_wall(0), vertical_wall(mesh.x[columns]), level_wall(0), FreeSide{}};
  Model model(std::move(mesh));
  model.linearise({}, model.state().q);
  return model.matrix();
}

inline linear::StencilMatrix mesh_matrix(std::size_t columns, std::size_t rows, double h1, double h2,
                                         double amplitude) {
  return mesh_matrix(columns, h1, std::vector<double>(rows, h2), amplitude);
}

/// Of one layer.
inline Eigen::MatrixXd dense(const linear::StencilMatrix& a) {
  const auto size = static_cast<Eigen::Index>(a.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
  for (const auto& [part, distance] : {std::pair{a.own, std::size_t{0}},
                                       {a.right, 1},
                                       {a.up, a.columns()},
                                       {a.up_right, a.columns() + 1},
                                       {a.up_left, a.columns() - 1}}) {
    for (Eigen::Index c = 0; c + static_cast<Eigen::Index>(distance) < size; ++c) {
      const Eigen::Index other = c + static_cast<Eigen::Index>(distance);
      result(c, other) += a[part][c];
      if (distance > 0) result(other, c) += a[part][c];
    }
  }
  return result;
}

inline Eigen::VectorXd random_vector(std::size_t size) {
  Noise noise(20);
  return Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(size), [&] { return noise(); });
}

inline Eigen::Map<const Eigen::VectorXd> as_vector(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace seiche::verification
