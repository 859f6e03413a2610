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
/// The pattern + - + - of the lattice's nodes changes no volume, so that nothing restores it, and grows in waves until
/// the lattice folds. Cells have g = u_0 - u_1 + u_2 - u_3 of it; forces on the six nodes of every two neighbours,
/// weighted as in the difference of their g, make that difference decay, so that the pattern decays at a given rate.
/// They keep momentum, and on equal parallelograms angular momentum; motions of second degree over two cells have
/// nothing of it, and velocities cos(k1 x + k2 y) decay at
///
///     rate s1^2 s2^2 (s1^2 + s2^2)/2,   s_i = sin(k_i h_i/2).
///
/// Fronts that are too steep break (breaking.hpp).
///
/// A layer that absorbs waves makes all velocities decay, u' = -rate u, at a rate that each column was given at the
/// beginning: let it grow smoothly from 0 over about a wavelength before a wall, or waves turn back at its edge. On
/// sides that prescribe velocities it must be 0.
///
/// All take energy and give none back, over steps of any length: implicit in the speeds that they slow down.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/breaking.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/models/dispersive_shallow_water_2d/push.hpp"
#include "seiche/models/dispersive_shallow_water_2d/rows.hpp"

namespace seiche::dispersive_shallow_water_2d {

struct DragSettings {
  double manning = 0;         ///< n [s/m^(1/3)]; smooth concrete: 0.011 to 0.013
  double shore_rate = 0;      ///< [1/s]
  double lattice_rate = 0;    ///< of the pattern + - + - [1/s]; a few times the frequency of steep waves
  double breaking_slope = 0;  ///< of a surface that begins to break (breaking.hpp); 0 for none
  /// Rate of an absorbing layer [1/s] at the first place of a column; empty for none. Not with a moving window.
  std::function<double(Point)> absorption = {};
};

class Drag {
 public:
  /// Throws std::invalid_argument for negative settings, rates of absorption that are negative or not finite, and for a
  /// shore_rate without a shoreline on the south side.
  /// @param inertia  alpha of the model
  Drag(DragSettings settings, const Lattice& lattice, double inertia);

  [[nodiscard]] bool active() const {
    return settings_.manning > 0 || settings_.shore_rate > 0 || settings_.lattice_rate > 0 ||
           settings_.breaking_slope > 0;
  }
  [[nodiscard]] bool absorbs() const { return !absorption_.empty(); }
  /// Depths, directions and, of a new step, steep places at q = (x, y, z).
  void measure(const Lattice& lattice, std::span<const double> volumes, mechanics::Input q, bool new_step = true);
  /// Slows velocities u = (u, v, w) down over h.
  void slow(std::span<const double> masses, const InverseMasses& inverse, double gravity, double h,
            mechanics::Output u) const;
  /// What the layer leaves of velocities after h. Before forces: those that balance each other must not be absorbed.
  void absorb(double h, mechanics::Output u) const;

  [[nodiscard]] const BreakingFronts& breaking() const { return breaking_; }
  /// At the end of a step.
  void settle() const { breaking_.settle(); }
  /// Breaking fronts of another flow on a lattice of this shape go on.
  void continue_from(const Drag& before) { breaking_.continue_from(before.breaking_); }
  /// As Model::shift_east.
  void shift_east() { breaking_.shift_east(); }

 private:
  void slow_pattern(std::span<const double> masses, const InverseMasses& inverse, double h, mechanics::Output u) const;

  DragSettings settings_;
  plan_lattice::Shape shape_;
  std::vector<double> depth_, area_;
  std::vector<Point> along_;        ///< the shore, at the markers of the south side
  std::vector<double> absorption_;  ///< rates of the nodes; empty for none
  // Of the pattern + - + -: over what each node has in all pairs, and what they push.
  mutable std::vector<double> share_;
  mutable std::vector<Impulse> impulse_;
  BreakingFronts breaking_;
};

}  // namespace seiche::dispersive_shallow_water_2d
