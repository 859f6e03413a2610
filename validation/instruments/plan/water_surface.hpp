/// The water's surface in lattices with improved dispersion: what a gauge sees.
///
/// As in a channel (dispersive_shallow_water_1d/water_surface.hpp): the markers carry z, and the surface is
///
/// @f[ \zeta = \sqrt{1 + \gamma K} \, z, \qquad \left(1 + \frac{\gamma K}{4}\right) \zeta =
///     \left(1 + \frac{3 \gamma K}{4}\right) z, \qquad K = -\nabla \cdot (H^2 \nabla) @f]
///
/// with the K of the energy (element.hpp) and the area around every node, a quarter of that of its cells.
/// Waves over equal rectangles are higher by (1 + 3 s/4)/(1 + s/4), s = gamma H^2 Q. zeta - z holds no water, and none
/// of it flows through the lattice's sides. Over water of one depth along an axis it is the channel's own.
///
/// When not to use it: to move water. gamma = 0: zeta = z.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/require.hpp"
#include "seiche/shallow_water/dispersive_surface.hpp"

namespace seiche::validation {

/// Keeps its arrays, and the last difference as a first guess, from reading to reading.
class WaterSurface {
 public:
  /// @param gamma  0 for none. Throws std::invalid_argument for a negative one.
  WaterSurface(plan_lattice::Shape shape, double gamma)
      : shape_(shape),
        gamma_(gamma),
        matrix_(shape.columns + 1, shape.rows + 1),
        push_(shape.columns + 1, shape.rows + 1),
        beyond_(shape.columns + 1, shape.rows + 1),
        surface_(shape.nodes()) {
    require_not_negative("gamma", gamma);
  }

  /// Elevations of the nodes, valid until the next reading. Throws linear::NotConverged, NotPositiveDirection.
  /// @param volumes  of the cells
  /// @param q        x of all nodes, y, z
  std::span<const double> read(std::span<const double> volumes, mechanics::Input q) {
    const auto z = q.last(shape_.nodes());
    if (gamma_ == 0) {
      std::ranges::copy(z, surface_.begin());
      return surface_;
    }
    assemble(volumes, q);
    const auto multiply = [&](const linear::LatticeArray& in, linear::LatticeArray& out) {
      return matrix_.multiply_and_dot(in, out);
    };
    const auto precondition = [&](std::span<const double> residual, std::span<double> better, double) {
      const double* const own = matrix_[matrix_.own];
      for (std::size_t node = 0; node < better.size(); ++node) better[node] = residual[node] / own[node];
    };
    solver_.solve(multiply, precondition, push_, beyond_, {.tolerance = accuracy});
    for (std::size_t node = 0; node < surface_.size(); ++node) surface_[node] = z[node] + beyond_.data()[node];
    return surface_;
  }
  std::span<const double> read(const dispersive_shallow_water_2d::Flow& flow) {
    return read(flow.model().first_volumes(), flow.state().q);
  }

 private:
  static constexpr double above = DispersiveSurface::above;
  static constexpr double below = DispersiveSurface::below;
  static constexpr double accuracy = 1e-8;  // of zeta - z, relative

  void assemble(std::span<const double> volumes, mechanics::Input q) {
    matrix_.clear();
    std::ranges::fill(push_.values(), 0.0);
    double* const push = push_.data();
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const auto [c0, c1, c2, c3] = shape_.corners(cell);
      const dispersive_shallow_water_2d::Diagonals at(q, shape_, cell);
      const Vector3 a = at.a;
      const Vector3 b = at.b;
      const double area = at.area();
      // The energy's form in the differences of z along the diagonals 0-2 and 1-3.
      const double weight = gamma_ / 4 * std::pow(volumes[cell], 2) / std::pow(area, 3);
      const double first = weight * (b.x * b.x + b.y * b.y);
      const double second = weight * (a.x * a.x + a.y * a.y);
      const double both = -weight * (a.x * b.x + a.y * b.y);
      const double along_first = (above - below) * (first * a.z + both * b.z);
      const double along_second = (above - below) * (both * a.z + second * b.z);
      push[c0] -= along_first;
      push[c1] -= along_second;
      push[c2] += along_first;
      push[c3] += along_second;
      for (const std::size_t node : {c0, c2}) matrix_[matrix_.own][node] += 0.25 * area + below * first;
      for (const std::size_t node : {c1, c3}) matrix_[matrix_.own][node] += 0.25 * area + below * second;
      matrix_[matrix_.up_right][c0] -= below * first;
      matrix_[matrix_.up_left][c1] -= below * second;
      matrix_[matrix_.right][c0] += below * both;
      matrix_[matrix_.up][c1] -= below * both;
      matrix_[matrix_.right][c3] += below * both;
      matrix_[matrix_.up][c0] -= below * both;
    }
  }

  plan_lattice::Shape shape_;
  double gamma_;
  linear::StencilMatrix matrix_;  // areas and gamma K/4 of them
  linear::LatticeArray push_;     // gamma K/2 z
  linear::LatticeArray beyond_;   // zeta - z
  linear::ConjugateGradients<> solver_;
  std::vector<double> surface_;
};

}  // namespace seiche::validation
