/// The moving shoreline of the plan model: markers at depth zero, which slide on the bottom.
///
/// The potential energy of water over a bottom is g int (z^2 - b^2)/2 dA. As long as the wetted area stays, the
/// bottom's part is constant; at a shoreline edge p -> q (water on the left) it is that of the area which the edge has
/// flooded since the beginning, when it was p0 -> q0. With P(s) = p0 + s (p - p0), Q(s) likewise,
///
///     int b^2/2 dA = int_0^1 ds int_0^1 dt (1/2) [(1 - t) b(P) + t b(Q)]^2 [(1 - t)(p - p0) + t (q - q0)] x (Q - P)
///
/// Along the edge b is replaced by what the surface over it is, linear between the markers: water at rest, whose
/// markers stand at z = b = 0, feels no force on any curved shore. The integral over s is Gauss's of three points,
/// exact for bottoms of degree two, and the forces are its exact gradient.
///
/// Of each of its cells a marker has the mass V/6, what linear elements give it: with it a surface that is inclined
/// along the shore accelerates as it should. Inclined across the shore a surface would ask for V/12
/// (TipMass::consistent of dispersive_shallow_water_1d); with that the edge of the water outruns what is beside it and
/// tangles the lattice.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::dispersive_shallow_water_2d {

using mechanics::Input;
using mechanics::Output;

class Shoreline {
 public:
  /// Share of a cell's mass that its node on the shoreline has.
  static constexpr double share_of_mass = 1.0 / 6;

  /// @param q  places of all nodes at the beginning: x, y, z
  Shoreline(plan_lattice::Shape shape, const plan_lattice::Sides& sides, std::shared_ptr<const PlanBottom> bottom,
            Input q);

  /// Whether each node is on it.
  [[nodiscard]] const std::vector<char>& marks() const { return marks_; }
  /// Puts the markers on the bottom.
  void land(Output q) const;
  /// Normals with which a straight way from q0 to q1 along the bottom is tangent to it: those of the discrete gradient.
  void tilt_between(Input q0, Input q1, Normals& normals) const;

  /// int b^2/2 dA over what has been flooded since the beginning, less what has fallen dry.
  /// @param counted  marks the cells whose edges count; empty: all
  [[nodiscard]] double bottom_moment(Input q, std::span<const char> counted = {}) const;
  /// Adds the forces of the bottom's part of the energy to those on the nodes along x, y, z: at q0 if q1 is the same,
  /// else by the discrete gradient over the segment: Simpson's mean, corrected along the segment.
  void push(Input q0, Input q1, double gravity, Output forces) const;

 private:
  using Ends = std::array<double, 4>;  ///< x, y of p, of q
  struct Edge {
    std::array<std::size_t, 2> nodes{};
    std::size_t cell = 0;  ///< beside it
    Ends first{};          ///< p0, q0
  };
  struct Moment {
    double value = 0;
    Ends gradient{};
  };

  [[nodiscard]] Ends ends(const std::array<std::size_t, 2>& nodes, Input q) const;
  [[nodiscard]] Moment moment(const Edge& edge, const Ends& at) const;
  [[nodiscard]] Moment moment_between(const Edge& edge, const Ends& from, const Ends& to) const;

  std::size_t nodes_;
  std::shared_ptr<const PlanBottom> bottom_;
  std::vector<char> marks_;
  std::vector<std::size_t> markers_;
  std::vector<Edge> edges_;
};

}  // namespace seiche::dispersive_shallow_water_2d
