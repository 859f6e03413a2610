/// Drag on the columns of the plan model: friction at the bottom, and what holds the edge of the water to the water
/// beside it.
///
/// Friction at the bottom after Manning, on the horizontal velocity u at depth H:
///
/// @f[ \dot{\mathbf{u}} = - g n^2 \frac{|\mathbf{u}| \, \mathbf{u}}{H^{4/3}} @f]
///
/// H is the mean depth of the cells around a node, so that it does not vanish at a shoreline.
///
/// The thin edge of the water slides along a shore faster than what is beside it and would shear the lattice without
/// end. Between a marker of a shoreline on the south side and its neighbour in the next row a force along the shore
/// makes the difference d of their speeds along it decay, d' = -rate d. It acts on both and keeps momentum.
///
/// Either takes energy and gives none back, over steps of any length: implicit in the speeds that it slows down.
#pragma once

#include <span>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/models/dispersive_shallow_water_2d/rows.hpp"

namespace seiche::dispersive_shallow_water_2d {

struct DragSettings {
  double manning = 0;     ///< n [s/m^(1/3)]; smooth concrete: 0.011 to 0.013
  double shore_rate = 0;  ///< [1/s]
};

class Drag {
 public:
  /// Throws std::invalid_argument for negative settings, and for a shore_rate without a shoreline on the south side.
  Drag(DragSettings settings, const Lattice& lattice);

  [[nodiscard]] bool active() const { return settings_.manning > 0 || settings_.shore_rate > 0; }
  /// Depths and directions at places q = (x, y, z).
  void measure(const Lattice& lattice, std::span<const double> volumes, mechanics::Input q);
  /// Slows velocities u = (u, v, w) down over h.
  void slow(std::span<const double> masses, const InverseMasses& inverse, double gravity, double h,
            mechanics::Output u) const;

 private:
  DragSettings settings_;
  std::size_t columns_;
  std::vector<double> depth_, area_;
  std::vector<Point> along_;  ///< the shore, at the markers of the south side
};

}  // namespace seiche::dispersive_shallow_water_2d
