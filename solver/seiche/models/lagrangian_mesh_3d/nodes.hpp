/// How the nodes of a mesh may move: their masses and what holds them.
///
/// With P the projector on what sides and bottom leave of a node's motion its inverse mass is W = P/mass. Where P is
/// diagonal its numbers are wx, wy, wz, 0 or 1/mass. Nodes on a wall that is not parallel to an axis and those on an
/// uneven bottom have wx = wy = wz = 0, and the model adds their W node by node: they are few.
///
/// Nodes of level 0 slide on an uneven bottom z = b(x, y). To each belongs one more constraint, z - b = 0, whose force
/// is along its gradient (-b_x, -b_y, 1). It is eliminated node by node: with Q the projector on what the sides leave,
/// z included, and m the unit vector along Q (-b_x, -b_y, 1), P = Q - m m^T.
///
/// The one-step scheme keeps these constraints as it keeps the cells' volumes: on a plane to round-off, else with a
/// bounded error of order tau^2 (z - b - (tau^2/8) u^T (Hessian of z - b) u is constant where b is quadratic). A
/// conservative step takes the mean gradient over the node's way, by Gauss's rule of three points, and keeps z = b to
/// round-off where b is of degree six in effect over the way of one step.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 1.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/lagrangian_mesh_3d/mesh.hpp"

namespace seiche::lagrangian_mesh_3d {

/// A node whose horizontal velocity is prescribed, but for the component along `wall`, which is 0.
struct Driven {
  std::size_t node;
  const plan_lattice::DrivenSide* side;
  Point wall = {0, 0};  ///< unit normal of the wall that ends there, or 0
};

class Nodes {
 public:
  /// xx, yy, zz, xy, xz, yz.
  using Symmetric = std::array<double, 6>;

  /// Sides hold the nodes of all levels as they hold those of level 0.
  /// Throws std::invalid_argument (plan_lattice::bound_nodes; masses that are not positive).
  Nodes(const Mesh& mesh, std::span<const double> volumes, double density);

  /// New masses for other volumes of the same mesh.
  void weigh(const Mesh& mesh, std::span<const double> volumes, double density);
  /// P over an uneven bottom where the nodes are, or with its mean gradient over their ways. Throws Infeasible.
  void turn(mechanics::Input q0, mechanics::Input q1);

  [[nodiscard]] std::size_t size() const { return mass_.size(); }
  [[nodiscard]] const std::vector<double>& mass() const { return mass_; }
  /// wx, wy, wz.
  [[nodiscard]] const std::vector<double>& w(std::size_t axis) const { return w_[axis]; }
  /// Nodes with a W of their own, in ascending order.
  [[nodiscard]] const std::vector<std::size_t>& slanted() const { return slanted_; }
  [[nodiscard]] std::span<const Driven> driven() const { return driven_; }
  /// P.
  [[nodiscard]] Symmetric left(std::size_t node) const;
  /// Takes what P forbids out of velocities u = (u, v, w) of the nodes before this one; driven components are 0.
  void project(std::size_t nodes, std::span<double> u) const;
  /// Of nodes on an uneven bottom, which are the first ones.
  [[nodiscard]] std::size_t on_bottom() const { return on_bottom_.size(); }

 private:
  struct HorizontalFreedom {
    double xx = 1, yy = 1, xy = 0;
  };

  std::shared_ptr<const Sides> sides_;  // what driven nodes point to, in copies too
  std::shared_ptr<const PlanBottom> bottom_;
  std::size_t held_below_;                  // nodes that do not rise
  std::vector<HorizontalFreedom> freedom_;  // of all levels
  std::vector<Symmetric> on_bottom_;        // P there
  std::vector<double> mass_;
  std::array<std::vector<double>, 3> w_;
  std::vector<std::size_t> slanted_;
  std::vector<Driven> driven_;
};

}  // namespace seiche::lagrangian_mesh_3d
