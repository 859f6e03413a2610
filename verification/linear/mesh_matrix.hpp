/// The matrix A = J M^-1 J^T of the pressure equation on a quadrilateral mesh (Frank 1994, ch. 2), smoothly deformed.
///
/// Rectangular cells before the deformation, rows upwards; every mesh node is displaced along half
/// cosines about two depths long, by at most `amplitude` times the smaller of length and depth. Nodes on the left and
/// right walls move only vertically, on the bottom only horizontally, at the top freely. A node's mass is a quarter of
/// the areas of the cells around it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "seiche/linear/conjugate_gradients.hpp"

namespace seiche::verification {

class DeformedMesh {
 public:
  struct Vector {
    double x = 0, y = 0;
  };

  /// Row heights from the bottom up.
  DeformedMesh(std::size_t columns, double h1, const std::vector<double>& row_heights, double amplitude)
      : columns_(columns), rows_(row_heights.size()) {
    std::vector<double> levels{0};
    for (const double height : row_heights) levels.push_back(levels.back() + height);
    const double length = h1 * static_cast<double>(columns);
    const double depth = levels.back();
    const double a = amplitude * std::min(length, depth);
    const double k = std::numbers::pi / length * std::max(1.0, std::round(length / (2 * depth)));
    const double l = std::numbers::pi / (2 * depth);
    for (const double y : levels) {
      for (std::size_t i = 0; i <= columns; ++i) {
        const double x = h1 * static_cast<double>(i);
        nodes_.push_back({x + a * std::sin(k * x) * std::cos(l * y), y + a * std::cos(k * x) * std::sin(l * y)});
      }
    }
  }

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Nodes of cell (i, j), counter-clockwise from the lower left one.
  [[nodiscard]] std::array<std::size_t, 4> corners(std::size_t i, std::size_t j) const {
    const std::size_t first = j * (columns_ + 1) + i;
    return {first, first + 1, first + columns_ + 2, first + columns_ + 1};
  }
  /// Gradients of the area of cell (i, j) by the positions of its corners.
  [[nodiscard]] std::array<Vector, 4> gradients(std::size_t i, std::size_t j) const {
    const auto [a, b, c, d] = corners(i, j);
    const Vector p{nodes_[c].x - nodes_[a].x, nodes_[c].y - nodes_[a].y};
    const Vector q{nodes_[d].x - nodes_[b].x, nodes_[d].y - nodes_[b].y};
    return {{{-q.y / 2, q.x / 2}, {p.y / 2, -p.x / 2}, {q.y / 2, -q.x / 2}, {-p.y / 2, p.x / 2}}};
  }
  [[nodiscard]] double area(std::size_t i, std::size_t j) const {
    const auto [a, b, c, d] = corners(i, j);
    return ((nodes_[c].x - nodes_[a].x) * (nodes_[d].y - nodes_[b].y) -
            (nodes_[d].x - nodes_[b].x) * (nodes_[c].y - nodes_[a].y)) /
           2;
  }
  /// Velocity that a unit force gives the node, along each coordinate; zero where it cannot move.
  [[nodiscard]] std::vector<Vector> mobilities() const {
    std::vector<double> mass(nodes_.size(), 0.0);
    for (std::size_t j = 0; j < rows_; ++j) {
      for (std::size_t i = 0; i < columns_; ++i) {
        for (const std::size_t node : corners(i, j)) mass[node] += area(i, j) / 4;
      }
    }
    std::vector<Vector> result(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const std::size_t i = n % (columns_ + 1);
      const std::size_t j = n / (columns_ + 1);
      result[n] = {i == 0 || i == columns_ ? 0 : 1 / mass[n], j == 0 ? 0 : 1 / mass[n]};
    }
    return result;
  }

 private:
  std::size_t columns_, rows_;
  std::vector<Vector> nodes_;
};

inline linear::StencilMatrix mesh_matrix(const DeformedMesh& mesh) {
  const std::size_t columns = mesh.columns();
  const std::size_t rows = mesh.rows();
  const std::vector<DeformedMesh::Vector> mobility = mesh.mobilities();
  linear::StencilMatrix a(columns, rows);
  // Sum of (corner of one cell, corner of the other) over the nodes they share.
  using Shared = std::array<std::size_t, 2>;
  const auto couple = [&](std::size_t i, std::size_t j, std::size_t i2, std::size_t j2,
                          std::initializer_list<Shared> shared) {
    const auto corners = mesh.corners(i, j);
    const auto first = mesh.gradients(i, j);
    const auto second = mesh.gradients(i2, j2);
    double sum = 0;
    for (const auto [c, d] : shared) {
      const auto w = mobility[corners[c]];
      sum += first[c].x * w.x * second[d].x + first[c].y * w.y * second[d].y;
    }
    return sum;
  };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t c = j * columns + i;
      a[a.own][c] = couple(i, j, i, j, {{0, 0}, {1, 1}, {2, 2}, {3, 3}});
      if (i + 1 < columns) a[a.right][c] = couple(i, j, i + 1, j, {{1, 0}, {2, 3}});
      if (j + 1 == rows) continue;
      a[a.up][c] = couple(i, j, i, j + 1, {{3, 0}, {2, 1}});
      if (i + 1 < columns) a[a.up_right][c] = couple(i, j, i + 1, j + 1, {{2, 0}});
      if (i > 0) a[a.up_left][c] = couple(i, j, i - 1, j + 1, {{3, 1}});
    }
  }
  return a;
}

inline linear::StencilMatrix mesh_matrix(std::size_t columns, std::size_t rows, double h1, double h2,
                                         double amplitude) {
  return mesh_matrix(DeformedMesh(columns, h1, std::vector<double>(rows, h2), amplitude));
}

}  // namespace seiche::verification
