/// Discrete nonlinear-dispersive shallow water seen from above (Frank 1994, ch. 4, on ch. 3's formulas 8-14).
///
/// Markers (x, y, z) on the surface move material columns of water that stay straight and normal to the bottom; the
/// volume of every cell between the bilinear surface and the bottom is constant:
///
/// @f[ T = \sum \frac{m}{2} \left[ |\mathbf{w}|^2 - (1 - \alpha) (\mathbf{w} \cdot \mathbf{n})^2 \right],
///     \qquad \alpha = 1/3 \tag{8, 11} @f]
/// @f[ \Pi = g \sum_s \int_s \frac{z^2}{2} \, dA \tag{9} @f]
/// @f[ V_s = \int_s z \, dA - \int_s b \, dA = \mathrm{const} \tag{10} @f]
///
/// all per unit density, with w a marker's velocity, n the bottom's normal, and integrals over the bilinear patches s
/// (Pi less int b^2/2 dA: shoreline.hpp). In one dimension this is dispersive_shallow_water_1d; in the limit of fine
/// cells over a level bottom the Green-Naghdi equations
///
/// @f[ \frac{\partial H}{\partial t} + \nabla \cdot (H \mathbf{u}) = 0, \qquad
///     \frac{D\mathbf{u}}{Dt} + g \nabla H = -\frac{\alpha}{H} \nabla \left( H^2 \frac{D^2 H}{Dt^2} \right) @f]
///
/// z counts from still water: a lake at rest has lambda = 0 and stays at rest bit by bit over any bottom.
///
/// The class is what mechanics::OneStep and ConservativeStep step: q = (x of all nodes, y, z), u = (u, v, w). Over an
/// uneven bottom velocities are carried along with the bottom's tangent plane, by the smallest rotation that takes its
/// normal to the next; along walls by the isometry of what the wall leaves (lattice.hpp). It is rarely used alone:
/// see flow.hpp.
///
/// Conserves to round-off: mass and momentum (no walls, level bottom) with every scheme, angular momentum about the
/// vertical with OneStep (all without drag, drag.hpp), energy and volumes with ConservativeStep, also over uneven
/// bottoms: volumes and potential are polynomials, and Simpson's mean of their gradients is exact. Dispersion in closed
/// form: exact/lattice_dispersion.hpp.
///
/// Waves may be shorter with improved dispersion (element.hpp); trains of them need what keeps the lattice
/// from tangling, and layers that absorb (drag.hpp).
///
/// When not to use it: waves shorter than about two depths; lattices that shear for long, as in steady eddies;
/// overturning.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapters 3 and 4.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "seiche/lattice/surface_patches.hpp"
#include "seiche/lattice/water.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/constraint_solver.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/dispersive_shallow_water_2d/drag.hpp"
#include "seiche/models/dispersive_shallow_water_2d/element.hpp"
#include "seiche/models/dispersive_shallow_water_2d/lattice.hpp"
#include "seiche/models/dispersive_shallow_water_2d/shoreline.hpp"
#include "seiche/ranges.hpp"

namespace seiche::dispersive_shallow_water_2d {

using lattice::Corner;
using mechanics::Interval;

struct Settings {
  double gravity = 1;        ///< [m/s^2]
  double inertia = 1.0 / 3;  ///< alpha, of the motion normal to the bottom
  /// Of improved dispersion (element.hpp): 1/15, with inertia 1/3 + 1/15; 0 in Frank's own model.
  double gamma = 0;
  linear::SolverMethod solver = linear::SolverMethod::automatic;
  double tolerance = 1e-10;  ///< relative residual of iterative solvers; 1e-13 where conservation is measured
  DragSettings drag = {};    ///< takes energy; none in Frank's own model

  static constexpr auto ranges() {
    return std::array{Number{"gravity", &Settings::gravity, Range::not_negative()},
                      Number{"inertia", &Settings::inertia, Range::within(1e-3, 1)},
                      Number{"gamma", &Settings::gamma, Range::not_negative()}};
  }
};

struct Forcing {
  /// Horizontal force per unit mass on the node that was at `label` at the beginning [m/s^2]; empty for none.
  std::function<Point(Point label, double time)> body_force = {};
};

struct Velocity {
  double u = 0;
  double v = 0;
  double w = 0;  ///< of the surface
};
using VelocityAt = std::function<Velocity(double x, double y)>;
/// Velocities at the beginning: of places, empty for water at rest; or of each node in turn.
using InitialVelocity = std::variant<VelocityAt, std::vector<Velocity>>;

class Model : public lattice::Water<Column, Model> {
 public:
  /// Masses and volumes from the lattice. Throws std::invalid_argument (lattice.hpp, sides.hpp, settings out of range).
  explicit Model(Lattice lattice, Settings settings = {}, Forcing forcing = {});
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  static constexpr bool warm_start = true;

  /// The lattice as it was given with these velocities; what sides forbid is taken out, the projection on constant
  /// volumes is mechanics/start.hpp's. Throws std::invalid_argument for velocities that are not as many as the nodes.
  [[nodiscard]] mechanics::State state(const InitialVelocity& velocity = {}) const;

  // What mechanics/constrained_model.hpp asks for, besides lattice::Water.
  void kick(double h, Output u) const;
  void enter(Input q, Output u) const;
  void settle(Interval when, Output q, Output u) const;
  [[nodiscard]] double place(std::size_t rate) const { return lattice_.x[rate % n_]; }

  /// Zero for still water. @param counted  marks the cells whose water counts; empty: all
  [[nodiscard]] double potential_energy(Input q, std::span<const char> counted = {}) const;

  [[nodiscard]] Shape shape() const { return lattice_.shape; }
  [[nodiscard]] std::size_t nodes() const { return n_; }
  /// As given at the beginning, or at the last shift of a moving window.
  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] bool has_driven_sides() const { return masses_.has_driven_sides(); }
  [[nodiscard]] bool has_shoreline() const { return shoreline_.has_value(); }
  [[nodiscard]] bool absorbs() const { return drag_.absorbs(); }
  [[nodiscard]] const BreakingFronts& breaking() const { return drag_.breaking(); }
  /// Fronts that broke in another flow's model, of a lattice of this shape, break on.
  void continue_breaking(const Model& before) { drag_.breaking().continue_from(before.breaking()); }
  /// Of a mean square at the beginning [m].
  [[nodiscard]] double cell_size() const { return std::sqrt(mean_area_); }

  /// Drops the west column and puts a column at rest, as wide as the last one was at the beginning, before the east
  /// side. The nodes that become the west side keep their velocities, so that nothing jolts; no force changes those
  /// that the side forbids. State and model change together.
  void shift_east(mechanics::State& state);
  /// Of a model of a part of a lattice, after shift_east of the models of all parts and with the places that their
  /// owners have: brings what the shift changed beside the state, first places, volumes and masses, to that of the
  /// whole.
  /// @param nodes  gives numbers of nodes that other parts own (x, y, z one after the other) their owners' values
  /// @param cells  likewise, one number per cell
  void join_shift(const std::function<void(Output)>& nodes, const std::function<void(Output)>& cells) {
    join_columns(lattice_.x, lattice_.y, nodes, cells);
    sum_masses();
  }
  /// Of the columns that shift_east appends.
  [[nodiscard]] double east_width() const { return east_width_; }

  // What lattice::Water asks for.
  /// Throws mechanics::Infeasible where a cell tangles, a marker touches the bottom or leaves it.
  void gather(Input q0, Input q1, Input at, int sweep);
  [[nodiscard]] std::array<const double*, 6> mobility() const {
    const InverseMasses& w = masses_.inverse();
    return {w.xx.data(), w.yy.data(), w.zz.data(), w.xy.data(), w.xz.data(), w.yz.data()};
  }
  [[nodiscard]] bool full_row(std::size_t row) const { return masses_.full(row); }
  [[nodiscard]] std::span<const double> node_masses() const { return masses_.mass(); }
  void look_below(Input q) const {
    if (bottom_) find_normals(q, other_normals_);
  }
  /// After look_below.
  [[nodiscard]] std::array<double, 3> momentum_of(std::size_t k, Input u) const;
  [[nodiscard]] double cell_volume(Input q, std::size_t cell) const;
  [[nodiscard]] double cell_shape(Input q, std::size_t cell) const;

 private:
  void sum_masses();
  void find_normals(Input q, Normals& normals) const;
  void measure(Input q, double weight, bool add);
  void stand(Input q);
  [[nodiscard]] bool on_shore(std::size_t node) const { return shoreline_ && shoreline_->marks()[node] != 0; }
  void carry(Input q, bool onto, Output u) const;

  Lattice lattice_;
  Settings settings_;
  Forcing forcing_;
  NodeMasses masses_;
  double mean_area_ = 0;
  double east_width_ = 0;
  std::optional<BottomVolume> bottom_;
  std::optional<Shoreline> shoreline_;
  lattice::SurfacePatches surface_;
  Drag drag_;
  Normals normals_;                // of the bottom at the linearised configuration
  mutable Normals other_normals_;  // at the beginning or end of the step
};

}  // namespace seiche::dispersive_shallow_water_2d
