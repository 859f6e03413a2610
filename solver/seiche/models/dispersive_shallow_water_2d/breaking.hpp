/// Breaking fronts in plan: where the water gives energy to turbulence.
///
/// A front is a run of neighbours on a line of the lattice that come nearer to each other, by 0.0015 c/H of their
/// distance in a second or faster: a hundredth of the rate at which Kennedy et al. (J. Waterway 126 (2000) 39) let
/// breaking end, so that its foot is not where velocities converge by their noise. It begins to break when the
/// surface between two of them is steeper than a slope, and goes on until the Froude number of a bore of its depths
/// falls below 1.3: what breaks on is the front that overlaps the one before. All within exchange horizontal momentum
/// like in a viscous fluid, with the viscosity that leaves a bore of the model's equations without waves behind it
/// (shallow_water/breaking_bore.hpp),
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
#pragma once

#include <array>
#include <span>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/models/dispersive_shallow_water_2d/rows.hpp"

namespace seiche::dispersive_shallow_water_2d {

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
  void continue_from(const BreakingFronts& before);
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
    std::size_t first = 0;  ///< pair
    std::size_t pairs = 0;
    double damping = 0;  ///< share of the viscosity
  };

  void look(std::span<const double> volumes, mechanics::Input q, std::size_t line, bool is_row);
  void find(double gravity, mechanics::Input u) const;
  [[nodiscard]] static double damping(std::span<const Pair> pairs);
  void mix(const Front& front, double time, std::span<const double> masses, const InverseMasses& inverse,
           mechanics::Input before, mechanics::Output u) const;

  double slope_;
  double inertia_;
  plan_lattice::Shape shape_;
  std::vector<Pair> pairs_;         ///< of the lines that are looked at
  std::vector<std::size_t> lines_;  ///< where each of them ends
  // Found with the velocities, which come after the configuration.
  mutable bool found_ = false;
  mutable std::vector<Front> fronts_;
  mutable std::size_t going_on_ = 0;
  /// Pairs along rows, row by row; then those across, row by row: by the last step, and as found in this one.
  mutable std::vector<char> broke_, breaks_;
  // Of a front.
  mutable linear::TwoEndedTridiagonal matrix_;
  mutable std::vector<double> diagonal_, coupling_;
  mutable std::array<std::vector<double>, 2> speed_;
  mutable std::vector<double> before_;  // velocities that all fronts begin from
};

}  // namespace seiche::dispersive_shallow_water_2d
