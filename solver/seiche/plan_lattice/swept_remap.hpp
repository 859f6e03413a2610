/// What a lattice carries, brought to another one between the same sides through the quadrilaterals that the edges of
/// its cells sweep on their way: what leaves a cell comes into its neighbour.
///
/// Velocities at the new nodes come from the old ones (lattice_interpolant.hpp). What they have too little of a cell's
/// momentum, d_s, its corners get by their shares w of the masses,
///
/// @f[ \delta \mathbf{u}_k = \sum_s w_{sk} \mathbf{d}_s / m_k . @f]
///
/// References: C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227 (rezoned Lagrangian lattices);
/// L. G. Margolin, M. Shashkov, J. Comput. Phys. 184 (2003) 266 (remap through swept regions).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "seiche/geometry/curve.hpp"
#include "seiche/geometry/swept_quadrilateral.hpp"
#include "seiche/plan_lattice/lattice_interpolant.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

class SweptRemap {
 public:
  /// @param x, y    the old nodes, new_x, new_y the new ones; must outlive the object
  /// @param shares  of the mass of a cell that each node has
  /// Throws mechanics::Infeasible for a new node that is on none of the old cells, std::invalid_argument.
  SweptRemap(Shape shape, std::span<const double> x, std::span<const double> y, std::span<const double> new_x,
             std::span<const double> new_y, std::vector<double> shares)
      : shape_(shape), x_(x), y_(y), new_x_(new_x), new_y_(new_y), shares_(std::move(shares)), old_(shape, x, y) {
    for (std::size_t k = 0; k < shape.nodes(); ++k) places_.push_back(old_.find(new_point(k), at_node(k)));
  }

  [[nodiscard]] const LatticeInterpolant& old() const { return old_; }
  /// Where a new node is on the old lattice.
  [[nodiscard]] const LatticePlace& place(std::size_t node) const { return places_[node]; }
  [[nodiscard]] Point old_point(std::size_t node) const { return {x_[node], y_[node]}; }
  [[nodiscard]] Point new_point(std::size_t node) const { return {new_x_[node], new_y_[node]}; }
  [[nodiscard]] double share(std::size_t node) const { return shares_[node]; }

  /// Old and new ends of an edge, around the quadrilateral that it sweeps to its right.
  [[nodiscard]] std::array<Point, 4> swept(std::size_t p, std::size_t q) const {
    return {old_point(p), new_point(p), new_point(q), old_point(q)};
  }
  /// visit(point, its place on the old lattice) for the points of the rule in what an edge sweeps.
  template <class Visit>
  void each_swept(std::size_t p, std::size_t q, const Visit& visit) const {
    const LatticePlace a = at_node(p), b = places_[p], c = places_[q], d = at_node(q);
    each_swept_point(swept(p, q), [&](const SweptPoint& at) {
      using bilinear_patch::mix;
      visit(at, old_.find(at.place, {mix({a.i, b.i, c.i, d.i}, at.s, at.t), mix({a.j, b.j, c.j, d.j}, at.s, at.t)}));
    });
  }

  /// Velocity of a cell's mass. @param velocity  of a node
  template <class Velocity>
  [[nodiscard]] Point mean(std::size_t cell, const Velocity& velocity) const {
    double shares = 0;
    Point sum;
    for (const std::size_t k : shape_.corners(cell)) {
      shares += share(k);
      sum += share(k) * velocity(k);
    }
    return {sum.x / shares, sum.y / shares};
  }
  /// What nodes with these velocities have too little of the momenta of cells that hold `content` now.
  template <class Velocity>
  [[nodiscard]] std::vector<Point> lacking(std::span<const double> content, std::span<const Point> momentum,
                                           const Velocity& velocity) const {
    std::vector<double> mass(shape_.nodes(), 0.0);
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      for (const std::size_t k : shape_.corners(cell)) mass[k] += share(k) * content[cell];
    }
    std::vector<Point> change(shape_.nodes());
    for (std::size_t cell = 0; cell < shape_.cells(); ++cell) {
      const Point missing = momentum[cell] - content[cell] * mean(cell, velocity);
      for (const std::size_t k : shape_.corners(cell)) change[k] += share(k) / mass[k] * missing;
    }
    return change;
  }

 private:
  [[nodiscard]] LatticePlace at_node(std::size_t node) const {
    const std::size_t row = node / (shape_.columns + 1);
    return {.i = static_cast<double>(node - shape_.node(0, row)), .j = static_cast<double>(row)};
  }

  Shape shape_;
  std::span<const double> x_, y_, new_x_, new_y_;
  std::vector<double> shares_;
  LatticeInterpolant old_;
  std::vector<LatticePlace> places_;
};

// Where the nodes of a Lagrangian lattice are put when it is rezoned: along its rows, on given lines.

/// A row of nodes as a curve: the cubic through four of them, no farther from their polyline than a twentieth of its
/// edge. The nodes must outlive it; at least four.
class RowCurve {
 public:
  RowCurve(std::span<const double> x, std::span<const double> y) : x_(x), y_(y) {}

  /// At a place counted in nodes.
  [[nodiscard]] Point at(double number) const;
  /// Where it meets the line through two points, sought from a node on by at most two edges; where it does not, the
  /// place of the line beside the node.
  [[nodiscard]] Point meet(std::size_t node, Point from, Point to) const;

 private:
  std::span<const double> x_, y_;
};

/// Throws mechanics::Infeasible for a cell that is not convex.
void require_convex(const Shape& shape, std::span<const double> x, std::span<const double> y);

struct RezonedPlaces {
  std::vector<double> x, y;

  [[nodiscard]] Point operator[](std::size_t node) const { return {x[node], y[node]}; }
  void put(std::size_t node, Point place) {
    x[node] = place.x;
    y[node] = place.y;
  }
};

/// Farthest of a node at q = (x, y, ...) from its new place, over the shortest edge at the new place.
double farthest(const Shape& shape, std::span<const double> q, const RezonedPlaces& places);

}  // namespace seiche::plan_lattice
