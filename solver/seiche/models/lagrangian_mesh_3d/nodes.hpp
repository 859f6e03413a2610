/// How the nodes of a mesh may move: their masses and what holds them.
///
/// Inverse masses wx, wy, wz are 0 where a node cannot move along an axis by itself. A node on a wall that is not
/// parallel to an axis slides along a direction t: W = t t^T/m in plan, which the model adds node by node; they are
/// few. Nodes on an uneven bottom have wx = wy = wz = 0 too, and the W of Bottom.
#pragma once

#include <array>
#include <cstddef>
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
class Bottom {
 public:
  /// @param bottom   null for a level one, which leaves nothing to do
  /// @param freedom  of the nodes of level 0 in their order
  Bottom(std::shared_ptr<const PlanBottom> bottom, std::vector<HorizontalFreedom> freedom);

  /// 0 over a level bottom.
  [[nodiscard]] std::size_t nodes() const { return freedom_.size(); }
  /// Gradients where the nodes are, or their means over straight ways. Throws Infeasible.
  void turn(std::span<const double> x0, std::span<const double> y0, std::span<const double> x1,
            std::span<const double> y1);
  /// P - m m^T (xx, yy, zz, xy, xz, yz): what the bottom and the sides leave of a velocity or a force.
  [[nodiscard]] const std::array<double, 6>& left(std::size_t node) const { return left_[node]; }
  /// Takes the rest out of velocities u = (u, v, w) of all nodes.
  void project(std::span<double> u) const;

 private:
  std::shared_ptr<const PlanBottom> bottom_;
  std::vector<HorizontalFreedom> freedom_;
  std::vector<std::array<double, 6>> left_;
};

struct Slide {
  std::size_t node;
  Point direction;  ///< unit vector
};

/// A node whose horizontal velocity is prescribed, but for the component along `wall`, which is 0.
struct Driven {
  std::size_t node;
  const plan_lattice::DrivenSide* side;
  Point wall = {0, 0};  ///< unit normal of the wall that ends there, or 0
};

class Nodes {
 public:
  /// Sides hold the nodes of all levels as they hold those of level 0.
  /// Throws std::invalid_argument (plan_lattice::bound_nodes; masses that are not positive).
  Nodes(const Mesh& mesh, std::span<const double> volumes, double density);

  /// New masses for other volumes of the same mesh.
  void weigh(const Mesh& mesh, std::span<const double> volumes, double density);

  [[nodiscard]] std::size_t size() const { return mass_.size(); }
  [[nodiscard]] const std::vector<double>& mass() const { return mass_; }
  [[nodiscard]] const std::vector<double>& wx() const { return w_[0]; }
  [[nodiscard]] const std::vector<double>& wy() const { return w_[1]; }
  [[nodiscard]] const std::vector<double>& wz() const { return w_[2]; }
  [[nodiscard]] std::span<const Slide> slides() const { return slides_; }
  [[nodiscard]] std::span<const Driven> driven() const { return driven_; }
  /// Of the nodes of level 0 over an uneven bottom; empty over a level one.
  [[nodiscard]] const std::vector<HorizontalFreedom>& on_bottom() const { return on_bottom_; }
  /// What is left of a velocity at a place where nodes are held as this one; driven components are 0.
  [[nodiscard]] Vector allowed(std::size_t node, const Vector& velocity) const;

 private:
  void leave_to_bottom(std::size_t level);

  enum Freedom : unsigned char { along_x = 1, along_y = 2, along_z = 4 };

  std::shared_ptr<const Sides> sides_;  // what driven nodes point to, in copies too
  std::vector<double> mass_;
  std::array<std::vector<double>, 3> w_;
  std::vector<unsigned char> freedom_;
  std::vector<Slide> slides_;
  std::vector<HorizontalFreedom> on_bottom_;
  std::vector<Driven> driven_;
};

}  // namespace seiche::lagrangian_mesh_3d
