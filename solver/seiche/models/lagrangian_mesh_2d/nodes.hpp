/// How the nodes of a mesh may move: their masses and what holds them.
///
/// Inverse masses wx, wy are 0 where a node cannot move by itself. Nodes on inclined or curved walls have one rate, the
/// speed s' along the curve; it is kept as the velocity d s', d the curve's tangent, or its chord over a step. Such a
/// node has wx = wy = 0 and W = d d^T/m, which the model adds node by node: they are few.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

using mechanics::Input;
using mechanics::Output;

/// A node on an inclined or curved wall.
struct Slide {
  std::size_t node;
  const Curve* curve;
  Point direction;          ///< at the linearised configuration
  Point bend = {0, 0};      ///< d direction/ds there
  double contact_sign = 0;  ///< sign of the curve's moment in Pi if the node is where the free surface ends, else 0
};

/// A node whose place in x, or in both, is a function of time.
struct Driven {
  std::size_t node;
  bool both;
  std::function<Point(double time)> place, velocity;

  /// Mean velocity over an interval; the velocity at an instant.
  [[nodiscard]] Point rate(mechanics::Interval when) const;
  /// Among values along x of all nodes, then along y.
  void put(Point value, Output values, std::size_t nodes) const;
};

/// Of node k, from values along x of all nodes, then along y, ...; and back.
inline Point point_at(Input values, std::size_t nodes, std::size_t k) {
  return {values[k], values[nodes + k]};
}
inline void put_point(Point value, Output values, std::size_t nodes, std::size_t k) {
  values[k] = value.x;
  values[nodes + k] = value.y;
}
inline void add_point(Point value, Output values, std::size_t nodes, std::size_t k) {
  values[k] += value.x;
  values[nodes + k] += value.y;
}

class Nodes {
 public:
  /// Throws std::invalid_argument: a moving wall beside a bottom that is not level, a wall without a vertical component
  /// at which a free surface ends.
  Nodes(const Mesh& mesh, std::span<const double> areas, double density, bool tuned_surface_inertia);

  [[nodiscard]] std::size_t size() const { return mass_.size(); }
  [[nodiscard]] std::span<const double> mass() const { return mass_; }
  /// Inertia in y; the mass but for tuned surface nodes.
  [[nodiscard]] std::span<const double> inertia_y() const { return inertia_y_; }
  [[nodiscard]] const std::vector<double>& wx() const { return wx_; }
  [[nodiscard]] const std::vector<double>& wy() const { return wy_; }
  [[nodiscard]] std::span<const Slide> slides() const { return slides_; }
  [[nodiscard]] std::span<Slide> slides() { return slides_; }
  [[nodiscard]] std::span<const Driven> driven() const { return driven_; }

 private:
  void hold(const Mesh& mesh, std::size_t node, const std::vector<const Side*>& sides);
  void hold_corner(const Mesh& mesh, std::size_t i, std::size_t j);

  std::shared_ptr<const Sides> sides_;  // what slides and driven nodes point to, in copies too
  std::vector<double> mass_, inertia_y_, wx_, wy_;
  std::vector<Slide> slides_;
  std::vector<Driven> driven_;
};

/// The edges of the mesh at its free sides: potential energy of the polygon of water (Frank 1994, formula 7), and
/// pressure on it.
///
///     Pi = rho g sum (x_b - x_a)(y_a^2 + y_a y_b + y_b^2)/6,   from a to b with the water below
///
/// Only sides that can move are summed: what fixed sides contribute is constant.
class FreeEdges {
 public:
  explicit FreeEdges(const Mesh& mesh);

  [[nodiscard]] bool empty() const { return edges_.empty(); }
  /// First node that can belong to a free edge.
  [[nodiscard]] std::size_t first_node() const { return first_node_; }
  /// sum (x_b - x_a)(y_a^2 + y_a y_b + y_b^2)/6 [m^3].
  [[nodiscard]] double moment(Input q) const;
  /// Adds -weight times its gradient to the forces.
  void push_down(Input q, double weight, Output push) const;
  /// Adds weight times the force of a pressure p(x of the edge's middle): half p (dy, -dx) on either end of an edge.
  void press(const std::function<double(double)>& pressure, Input q, double weight, Output push) const;

 private:
  std::vector<std::array<std::size_t, 2>> edges_;  // passed so that the water is on the right hand
  std::size_t first_node_ = 0;
  std::size_t n_;
};

/// A potential that keeps the corners of cells from inverting.
///
///     Pi_c = stiffness sum over corners with s < s_0 of V_0^(3/2) (s_0/s - 1)^2,   s_0 = 0.3
///
/// s is the shape of a corner (mesh.hpp): twice the triangle at it over the cell's first area V_0. Nothing is felt by
/// corners above s_0; momenta are kept; energy is not kept to round-off by any scheme while a corner is below, for the
/// potential is not a polynomial.
class CornerBarrier {
 public:
  /// @param stiffness  [N/m^3], not negative
  explicit CornerBarrier(double stiffness) : stiffness_(stiffness) {}

  [[nodiscard]] bool active() const { return stiffness_ > 0; }
  /// Infinite where a corner has inverted.
  [[nodiscard]] double energy(const Mesh& mesh, Input first_areas, Input q) const;
  /// Adds weight times its forces.
  void push(const Mesh& mesh, Input first_areas, Input q, double weight, Output push) const;

 private:
  double stiffness_;
};

/// A potential that restores what Frank's own model leaves free: node motions (-1)^(i+j) change no area.
///
///     Pi_h = (kappa/2) sum over cells of |r0 - r1 + r2 - r3 - initial|^2
class Hourglass {
 public:
  /// @param stiffness  kappa [N/m^2]; 0 for none
  Hourglass(const Mesh& mesh, double stiffness);

  [[nodiscard]] bool active() const { return stiffness_ > 0; }
  [[nodiscard]] double energy(const Mesh& mesh, Input q) const;
  /// Adds weight times its forces.
  void push(const Mesh& mesh, Input q, double weight, Output push) const;

 private:
  double stiffness_;
  std::vector<Point> rest_;
};

}  // namespace seiche::lagrangian_mesh_2d
