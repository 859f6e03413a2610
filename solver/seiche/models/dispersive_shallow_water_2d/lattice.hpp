/// Markers of the plan model: a lattice of water columns between the bottom and the free surface.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/geometry/vector.hpp"
#include "seiche/models/dispersive_shallow_water_2d/element.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

using plan_lattice::Place;
using plan_lattice::Shape;
using plan_lattice::Sides;

/// Markers on the surface over a bottom.
struct Lattice {
  Shape shape;
  std::vector<double> x, y;  ///< places in plan [m]
  std::vector<double> z;     ///< elevations of the surface above still water [m]
  Sides sides = {};
  double depth = 1;  ///< of still water over a level bottom [m]
  /// Uneven bottom, which `depth` then does not describe; null for none.
  std::shared_ptr<const PlanBottom> bottom = {};

  /// Elevation of the bottom. Throws Infeasible where there is none.
  [[nodiscard]] double bed(double at_x, double at_y) const {
    return bottom ? bottom->slope(at_x, at_y).elevation : -depth;
  }
  /// Throws std::invalid_argument: fewer than one row or two columns, arrays of other lengths, values that are not
  /// finite, depth not positive, a cell with a corner that is not convex, a marker that is not above the bottom (by
  /// place); a shoreline without an uneven bottom, or a marker of it that is off the bottom by more than 1e-12.
  void require_valid() const;
};

/// A rectangle of equal cells, begin <= x <= end and south <= y <= north, under a given surface.
struct Rectangle {
  double begin = 0;
  double end = 0;
  double south = 0;
  double north = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::function<double(double x, double y)> elevation = {};  ///< of the surface; empty for still water
  Sides sides = {};
  double depth = 1;
  std::shared_ptr<const PlanBottom> bottom = {};
};
/// Throws std::invalid_argument for ends out of order.
Lattice rectangular_lattice(const Rectangle& rectangle);

// Masses of the plan model's nodes, and what sides and bottom leave of their freedom.
//
// A column keeps straight and normal to the bottom: with the bottom's unit normal n below the marker,
//
//     T = (m/2) [ |w|^2 - (1 - alpha)(w.n)^2 ],   M = m [I - (1 - alpha) n n^T],   W = [I + (1/alpha - 1) n n^T]/m
//
// On a side W is the inverse of M on the motions that are left. With P, the projector on them, and p = P n
//
//     W = [P + (1 - alpha)/(1 - (1 - alpha) |p|^2) p p^T]/m;
//
// on a shoreline a node keeps to the bottom and p = 0. Velocities that a side prescribes are imposed by the
// M-orthogonal projection.

/// Unit normals of the bottom below the nodes.
using Normals = std::vector<Vector3>;

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

  /// W over a bottom with these normals.
  void stand_on(const Normals& normals);
  /// Turns the normals of driven sides into those of the lattice x, y, and W with them.
  void turn_driven_sides(std::span<const double> x, std::span<const double> y, const Normals& normals);
  /// Carries velocities u = (u, v, w) from a bottom with some normals to one with others, by isometries of M: the
  /// smallest rotation that takes one normal to the other; on sides at rest a motion within what they leave.
  void carry(const Normals& from, const Normals& to, std::span<double> u) const;
  /// Imposes what the sides prescribe at this time on the velocities u = (u, v, w).
  /// @param all  false: only on nodes of driven sides
  void constrain(std::span<const double> q, double time, const Normals& normals, bool all, std::span<double> u) const;

 private:
  void bind(const plan_lattice::BoundNode& bound, const Normals& normals);
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
