/// How the nodes of a mesh may move: their masses and what holds them.
///
/// Inverse masses wx, wy are 0 where a node cannot move by itself. Nodes on inclined or curved walls have one rate, the
/// speed s' along the curve; it is kept as the velocity d s', d the curve's tangent, or its chord over a step. Such a
/// node has wx = wy = 0 and W = d d^T/m, which the model adds node by node: they are few.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/lagrangian_mesh_2d/mesh.hpp"

namespace seiche::lagrangian_mesh_2d {

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
  const MovingWall* wall;      ///< x only
  const PrescribedSide* path;  ///< both
};

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

  [[nodiscard]] Point driven_place(const Driven& node, double time) const;
  [[nodiscard]] Point driven_velocity(const Driven& node, double time) const;
  /// Mean velocity over an interval; the velocity at an instant.
  [[nodiscard]] Point driven_rate(const Driven& node, mechanics::Interval when) const;
  [[nodiscard]] Point label(std::size_t node) const { return {label_x_[node], label_y_[node]}; }

 private:
  void hold(const Mesh& mesh, std::size_t node, const std::vector<const Side*>& sides);
  void hold_corner(const Mesh& mesh, std::size_t i, std::size_t j);

  std::shared_ptr<const Sides> sides_;  // what slides and driven nodes point to, in copies too
  std::vector<double> label_x_, label_y_;
  std::vector<double> mass_, inertia_y_, wx_, wy_;
  std::vector<Slide> slides_;
  std::vector<Driven> driven_;
};

}  // namespace seiche::lagrangian_mesh_2d
