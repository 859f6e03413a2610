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

#include <span>
#include <vector>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"

namespace seiche::validation {

/// Keeps its arrays, and the last difference as a first guess, from reading to reading.
class WaterSurface {
 public:
  /// @param gamma  0 for none. Throws std::invalid_argument for a negative one.
  WaterSurface(plan_lattice::Shape shape, double gamma);

  /// Elevations of the nodes, valid until the next reading. Throws linear::NotConverged, NotPositiveDirection.
  /// @param volumes  of the cells
  /// @param q        x of all nodes, y, z
  std::span<const double> read(std::span<const double> volumes, mechanics::Input q);
  std::span<const double> read(const dispersive_shallow_water_2d::Flow& flow) {
    return read(flow.model().first_volumes(), flow.state().q);
  }

 private:
  void assemble(std::span<const double> volumes, mechanics::Input q);

  plan_lattice::Shape shape_;
  double gamma_;
  linear::StencilMatrix matrix_;  // areas and gamma K/4 of them
  linear::LatticeArray push_;     // gamma K/2 z
  linear::LatticeArray beyond_;   // zeta - z
  linear::ConjugateGradients<> solver_;
  std::vector<double> surface_;
};

}  // namespace seiche::validation
