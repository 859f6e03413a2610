/// Masses of the plan model's nodes, and what sides and bottom leave of their freedom.
///
/// A column keeps straight and normal to the bottom: with the bottom's unit normal n below the marker,
///
///     T = (m/2) [ |w|^2 - (1 - alpha)(w.n)^2 ],   M = m [I - (1 - alpha) n n^T],   W = [I + (1/alpha - 1) n n^T]/m
///
/// On a side W is the inverse of M on the motions that are left: S (S^T M S)^-1 S^T; on a shoreline, where a node keeps
/// to the bottom, (I - n n^T)/m. Velocities that a side prescribes are imposed by the M-orthogonal projection.
#pragma once

#include <span>
#include <vector>

#include "seiche/geometry/vector.hpp"
#include "seiche/models/dispersive_shallow_water_2d/element.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

/// Unit normals of the bottom below the nodes.
struct Normals {
  std::vector<double> x, y, z;

  explicit Normals(std::size_t nodes) : x(nodes), y(nodes), z(nodes) {}
  [[nodiscard]] Vector3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
  void put(std::size_t k, Vector3 normal) { x[k] = normal.x, y[k] = normal.y, z[k] = normal.z; }
};

class NodeMasses {
 public:
  /// @param sides  must outlive the object; other parameters of the first lattice
  NodeMasses(plan_lattice::Shape shape, const plan_lattice::Sides& sides, std::span<const double> x,
             std::span<const double> y, double inertia);

  [[nodiscard]] std::span<double> mass() { return mass_; }
  [[nodiscard]] std::span<const double> mass() const { return mass_; }
  [[nodiscard]] const InverseMasses& inverse() const { return inverse_; }
  /// Whether W has entries off its diagonal in a row of nodes.
  [[nodiscard]] bool full(std::size_t row) const { return full_[row] != 0; }
  [[nodiscard]] bool has_driven_sides() const { return has_driven_sides_; }

  /// W over a bottom with these normals; null: level.
  void stand_on(const Normals* normals);
  /// Turns the normals of driven sides into those of the lattice x, y, and W with them.
  /// @param normals  of the bottom; null: level
  void turn_driven_sides(std::span<const double> x, std::span<const double> y, const Normals* normals);
  /// Carries velocities u = (u, v, w) from a bottom with some normals to one with others, by isometries of M: the
  /// smallest rotation that takes one normal to the other; on sides at rest a motion within what they leave.
  void carry(const Normals& from, const Normals& to, std::span<double> u) const;
  /// Imposes what the sides prescribe at this time on the velocities u = (u, v, w).
  /// @param all  false: only on nodes of driven sides
  void constrain(std::span<const double> q, double time, const Normals* normals, bool all, std::span<double> u) const;

 private:
  void bind(const plan_lattice::BoundNode& bound, const Normals* normals);
  [[nodiscard]] Vector3 carried_along_side(const plan_lattice::BoundNode& bound, Vector3 from, Vector3 to,
                                           Vector3 u) const;

  double inertia_;  // alpha
  std::vector<plan_lattice::BoundNode> bound_;
  bool has_driven_sides_ = false;
  std::vector<double> mass_;
  InverseMasses inverse_;
  std::vector<char> full_;
};

}  // namespace seiche::dispersive_shallow_water_2d
