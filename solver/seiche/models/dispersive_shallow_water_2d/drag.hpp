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
/// the lattice tangles. Cells have g = u_0 - u_1 + u_2 - u_3 of it; forces on the six nodes of every two neighbours,
/// weighted as in the difference of their g, make that difference decay, so that the pattern decays at a given rate.
/// They keep momentum, and on equal parallelograms angular momentum; motions of second degree over two cells have
/// nothing of it, and velocities cos(k1 x + k2 y) decay at
///
///     rate s1^2 s2^2 (s1^2 + s2^2)/2,   s_i = sin(k_i h_i/2).
///
/// Fronts that are too steep break.
///
/// A layer that absorbs waves makes all velocities decay, u' = -rate u, at a rate that each column was given at the
/// beginning: let it grow smoothly from 0 over about a wavelength before a wall, or waves turn back at its edge. On
/// sides that prescribe velocities it must be 0.
///
/// All take energy and give none back, over steps of any length: implicit in the speeds that they slow down.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/element.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/ranges.hpp"

namespace seiche::dispersive_shallow_water_2d {

/// u += W impulse, horizontal.
inline void push(const InverseMasses& inverse, std::size_t k, Point impulse, mechanics::Output u) {
  const std::size_t n = inverse.xx.size();
  u[k] += inverse.xx[k] * impulse.x + inverse.xy[k] * impulse.y;
  u[n + k] += inverse.xy[k] * impulse.x + inverse.yy[k] * impulse.y;
  u[2 * n + k] += inverse.xz[k] * impulse.x + inverse.yz[k] * impulse.y;
}

/// Breaking fronts in plan: where the water gives energy to turbulence.
///
/// A front is a run of neighbours on a line of the lattice that come nearer to each other, by 0.0015 c/H of their
/// distance in a second or faster: a hundredth of the rate at which Kennedy et al. (J. Waterway 126 (2000) 39) let
/// breaking end, so that its foot is not where velocities converge by their noise. It begins to break when the
/// surface between two of them is steeper than a slope, and goes on until the Froude number of a bore of its depths
/// falls below 1.3: what breaks on is the front that overlaps the one before. All within exchange horizontal momentum
/// like in a viscous fluid, with the viscosity that leaves a bore of the model's equations without waves behind it
/// (shallow_water/relations.hpp),
///
/// @f[ \nu = 2 \sqrt{\alpha} \, H \sqrt{g H} \, \sqrt{1 - \frac{h_1 (h_1 + h_2)}{2 h_2^2}} @f]
///
/// H the mean depth of the cells beside two neighbours, h1 the depth at the lower end of the front, h2 that of its
/// highest place above there. Mass and momentum decide the depth behind a bore and the energy that it loses.
///
/// Fronts are those of the first velocities that a step asks for, so that sweeps of a conservative step end.
///
/// When not to use it: overturning itself, and jets; fronts along which the lattice is so coarse that they never get
/// steep.
class BreakingFronts {
 public:
  /// @param slope    of a surface that begins to break; 0 where measure is not called
  /// @param inertia  alpha of the model
  BreakingFronts(double slope, double inertia, plan_lattice::Shape shape);

  /// Lines with a steep place at q = (x, y, z), or with a front that broke.
  void measure(std::span<const double> volumes, mechanics::Input q);
  /// Exchanges momentum of velocities u = (u, v, w) over h, implicitly along each front. The first call after measure
  /// finds the fronts.
  void exchange(std::span<const double> masses, const InverseMasses& inverse, double gravity, double h,
                mechanics::Output u) const;

  /// Fronts of the last exchange that break because they did, and are not steep any more.
  [[nodiscard]] std::size_t going_on() const { return going_on_; }

  /// The step is done: what it found has broken. A step that fails leaves what broke before it.
  void settle() const { broke_ = breaks_; }
  /// What broke in another flow on a lattice of this shape breaks on.
  void continue_from(const BreakingFronts& before) { broke_ = before.broke_; }
  /// As Model::shift_east: what the last column has anew does not break.
  void shift_east();

 private:
  /// Two neighbours on a line.
  struct Pair {
    std::size_t from = 0;
    std::size_t to = 0;
    std::size_t place = 0;  ///< in what broke
    Point way{};
    double rise = 0;
    double depth = 0;
    double exchange = 0;  ///< mass that they exchange in a second behind a high bore, over the square root of gravity
    bool steep = false;
  };
  struct Front {
    std::span<const Pair> pairs;
    double damping;  ///< share of the viscosity
  };

  void look(std::span<const double> volumes, mechanics::Input q, std::size_t line, bool is_row);
  void find(double gravity, mechanics::Input u) const;
  [[nodiscard]] static double damping(std::span<const Pair> pairs);
  void mix(std::span<const Pair> pairs, double time, std::span<const double> masses, const InverseMasses& inverse,
           mechanics::Output u) const;

  double slope_;
  double inertia_;
  plan_lattice::Shape shape_;
  std::vector<Pair> pairs_;         ///< of the lines that are looked at
  std::vector<std::size_t> lines_;  ///< where each of them ends
  // Found with the velocities, which come after the configuration.
  mutable bool found_ = false;
  mutable std::vector<Front> fronts_;
  mutable std::size_t going_on_ = 0;
  /// Pairs in the order of Shape::each_edge: by the last step, and as found in this one.
  mutable std::vector<char> broke_, breaks_;
  // Of a front.
  mutable linear::TwoEndedTridiagonal matrix_;
  mutable std::vector<double> diagonal_, coupling_;
  mutable std::array<std::vector<double>, 2> speed_;
  mutable std::vector<double> before_;  // velocities that all fronts begin from
};

struct DragSettings {
  double manning = 0;         ///< n [s/m^(1/3)]; smooth concrete: 0.011 to 0.013
  double shore_rate = 0;      ///< [1/s]
  double lattice_rate = 0;    ///< of the pattern + - + - [1/s]; a few times the frequency of steep waves
  double breaking_slope = 0;  ///< of a surface that begins to break; 0 for none
  /// Rate of an absorbing layer [1/s] at the first place of a column; empty for none. Not with a moving window.
  std::function<double(Point)> absorption = {};

  static constexpr auto ranges() {
    return std::array{Number{"manning", &DragSettings::manning, Range::not_negative()},
                      Number{"shore_rate", &DragSettings::shore_rate, Range::not_negative()},
                      Number{"lattice_rate", &DragSettings::lattice_rate, Range::not_negative()},
                      Number{"breaking_slope", &DragSettings::breaking_slope, Range::not_negative()}};
  }
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
  [[nodiscard]] BreakingFronts& breaking() { return breaking_; }

 private:
  void slow_pattern(std::span<const double> masses, const InverseMasses& inverse, double h, mechanics::Output u) const;

  DragSettings settings_;
  plan_lattice::Shape shape_;
  std::vector<double> depth_, area_;
  std::vector<Point> along_;        ///< the shore, at the markers of the south side
  std::vector<double> absorption_;  ///< rates of the nodes; empty for none
  // Of the pattern + - + -: over what each node has in all pairs, and what they push.
  mutable std::vector<double> share_;
  mutable std::vector<Point> impulse_;
  BreakingFronts breaking_;
};

}  // namespace seiche::dispersive_shallow_water_2d
