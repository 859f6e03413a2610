/// Nodes of level 0 that slide on an uneven bottom z = b(x, y).
///
/// To each belongs one more constraint, z - b = 0, whose force is along its gradient (-b_x, -b_y, 1). It is eliminated
/// node by node: with P the projector on what the sides leave of the node's motion, z included, and m the unit vector
/// along P (-b_x, -b_y, 1), the node's inverse mass is
///
///     W = (P - m m^T)/mass.
///
/// The one-step scheme keeps these constraints as it keeps the cells' volumes: on a plane to round-off, else with a
/// bounded error of order tau^2 (z - b - (tau^2/8) u^T (Hessian of z - b) u is constant where b is quadratic). A
/// conservative step takes the mean gradient over the node's way, by Gauss's rule of three points, and keeps z = b to
/// round-off where b is of degree six in effect over the way of one step.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 1.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

namespace seiche::lagrangian_mesh_3d {

/// Projector on the horizontal directions that sides leave a bottom node.
struct HorizontalFreedom {
  double xx = 1;
  double xy = 0;
  double yy = 1;
};

class Bottom {
 public:
  /// @param bottom   null for a level one, which leaves nothing to do
  /// @param freedom  of the nodes of level 0 in their order
  Bottom(std::shared_ptr<const PlanBottom> bottom, std::vector<HorizontalFreedom> freedom);

  /// 0 over a level bottom.
  [[nodiscard]] std::size_t nodes() const { return freedom_.size(); }
  /// Gradients where the nodes are. Throws OutsidePlanBottom.
  void linearise(std::span<const double> x, std::span<const double> y);
  /// Mean gradients over straight ways. Throws OutsidePlanBottom.
  void linearise_between(std::span<const double> x0, std::span<const double> y0, std::span<const double> x1,
                         std::span<const double> y1);
  /// (P - m m^T) v at the last linearisation: what the bottom and the sides leave of a velocity or a force.
  [[nodiscard]] Vector along(std::size_t node, const Vector& v) const;

 private:
  void set(std::size_t node, double along_x, double along_y);

  std::shared_ptr<const PlanBottom> bottom_;
  std::vector<HorizontalFreedom> freedom_;
  std::vector<Vector> normal_;  // m
};

}  // namespace seiche::lagrangian_mesh_3d
