/// Discrete nonlinear-dispersive shallow water in one dimension (Frank 1994, ch. 3, formulas 8-14).
///
/// Particles i of mass m_i move along the bottom (rate p_i) and normal to it (rate r_i); markers (x_i, y_i) trace the
/// surface; the volume between neighbouring markers, over the bottom b(x), is constant:
///
/// @f[ T = \sum_i m_i \frac{p_i^2 + \alpha r_i^2}{2}, \qquad \alpha = 1/3 \tag{8} @f]
/// @f[ \Pi = \frac{\rho g}{2} \sum_j \Delta x_j \frac{y_j^2 + y_j y_{j+1} + y_{j+1}^2}{3}
///         - \frac{\rho g}{2} \int b^2 \, dx \tag{9} @f]
/// @f[ V_j = \Delta x_j \left( \frac{y_j + y_{j+1}}{2} - \overline{b}_j \right) = \mathrm{const} \tag{10} @f]
/// @f[ \dot{x} = p c - r s, \qquad \dot{y} = p s + r c \tag{11} @f]
/// @f[ m \dot{p} = F_x c + F_y s, \qquad \alpha m \dot{r} = -F_x s + F_y c, \qquad
///     F = \nabla \left( \sum_j \lambda_j V_j - \Pi \right) \tag{12} @f]
///
/// with b_j the mean of the bottom over cell j, and c, s the cosine and sine of its slope at x (channel.hpp: other
/// frames). In the limit of fine cells over a level bottom these are Serre's (Green and Naghdi's) equations (14). y
/// counts from the still-water level, so that a lake at rest has lambda = 0 and stays at rest exactly.
///
/// The class is what mechanics::OneStep (scheme A), OneStep with drift feedback (B) and ConservativeStep (C) step:
/// q = (x, y), u = (p, r). It is rarely used alone: see flow.hpp.
///
/// Conserves mass and, on a level bottom without walls, momentum to round-off with every scheme; energy and volumes to
/// O(tau^2) with A, to round-off with C. A wall marker has one rate, its vertical velocity r (p = 0); a tip has one, p.
///
/// Friction at the bottom and breaking fronts are options of the channel (channel.hpp). They act between
/// the steps, on the rates alone, and what they take is told.
///
/// When not to use it: waves shorter than about two depths (see exact/lattice_dispersion.hpp, and gamma in
/// channel.hpp); bores without breaking, which a conservative model cannot carry; overturning.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 3.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"
#include "seiche/models/dispersive_shallow_water_1d/markers.hpp"
#include "seiche/models/dispersive_shallow_water_1d/rows.hpp"

namespace seiche::dispersive_shallow_water_1d {

using mechanics::Input;
using mechanics::Interval;
using mechanics::Output;

/// What acts on the water besides gravity.
struct Forcing {
  /// Pressure on the surface [Pa] at place x and time t; empty for none.
  std::function<double(double x, double time)> surface_pressure = {};
  /// Forces per unit mass along p and r of every particle, at `time`, added to the two arrays; empty for none.
  std::function<void(double time, std::span<double> along, std::span<double> across)> body_force = {};
};

/// What friction and breaking take: energy [J/m], and momentum along the bottom [kg/s].
struct Losses {
  double friction = 0;
  double breaking = 0;
  double friction_impulse = 0;
};

class Model {
 public:
  /// Masses and rest volumes from the polygon through the markers. Throws std::invalid_argument.
  Model(Channel channel, const Markers& initial, Forcing forcing = {});

  /// The state of these markers; the rates are not yet projected on constant volumes (mechanics/start.hpp).
  [[nodiscard]] mechanics::State state_of(const Markers& markers) const;

  // What mechanics/constrained_model.hpp asks for.
  [[nodiscard]] std::size_t coordinates() const { return 2 * n_; }
  [[nodiscard]] std::size_t rates() const { return 2 * n_; }
  [[nodiscard]] std::size_t constraints() const { return cells_; }
  /// Throws mechanics::Infeasible where markers cross, the water is gone, or a marker left the bottom profile.
  void linearise(Interval when, Input q);
  /// Discrete gradients. The frames are held from the fourth sweep on: at a corner of the bottom they might flip for
  /// ever, and conservation does not depend on them.
  void linearise_between(Interval when, Input q0, Input q1, int sweep);
  void predict(Input from, Input u, double h, Output to) const;
  void advance(Input from, Input u, double h, Output to) const;
  void kick(double h, Output u) const;
  void constraint_rates(Input u, Output w) const;
  void react(Input mu, Output u) const;
  void solve(Input right_hand_side, Output mu);
  void settle(Interval when, Output q, Output u) const;
  void constraint_values(Input q, Output f) const;
  /// Fused steps go through blocks of markers from both ends to the middle, assembling and eliminating, and back,
  /// substituting and moving. Neither for periodic channels nor with forces besides gravity.
  [[nodiscard]] bool fuses_step() const;
  void fused_step(Interval when, Output q, Output u, Input target, Output multipliers);
  mechanics::SweepChange fused_sweep(Interval when, Input q0, Output q1, Input u0, Output mean, Input target, Output mu,
                                     int sweep);
  [[nodiscard]] double place(std::size_t rate) const;

  /// Friction and breaking of the channel act on the rates u over h at places q that stay: q and Pi are not touched,
  /// and what is lost of the kinetic energy is returned. Never gains any. Throws mechanics::Infeasible like linearise.
  Losses lose(double h, Input q, Output u);
  [[nodiscard]] bool loses() const { return channel_.friction.active() || channel_.breaking.has_value(); }
  /// By the last loss; none without breaking.
  [[nodiscard]] const std::optional<BreakingFronts>& fronts() const { return fronts_; }
  /// After a step that failed: as with these fronts before it.
  void take_back(const std::optional<BreakingFronts>& fronts);

  [[nodiscard]] double mass() const;                                     ///< [kg/m]
  [[nodiscard]] std::array<double, 1> momentum(Input q, Input u) const;  ///< horizontal [kg/s]
  [[nodiscard]] double kinetic_energy(Input q, Input u) const;           ///< [J/m]
  [[nodiscard]] double potential_energy(Input q) const;                  ///< [J/m], zero for water at rest

  [[nodiscard]] std::size_t size() const { return n_; }
  [[nodiscard]] const Channel& channel() const { return channel_; }
  [[nodiscard]] std::span<const double> masses() const { return mass_; }
  [[nodiscard]] std::span<const double> rest_volumes() const { return rest_volume_; }
  /// Velocities (u, v) of the markers from their rates, frames taken at q.
  void velocities(Input q, Input rates, Output u, Output v) const;
  /// Smallest depth over the markers that are not tips, at the last linearised configuration [m].
  [[nodiscard]] double smallest_depth() const { return smallest_depth_; }
  /// Tridiagonal solves so far.
  [[nodiscard]] long solves() const { return solves_; }

 private:
  static constexpr std::ptrdiff_t long_channel = 65536;  // markers, whose rows are larger than caches
  static constexpr int sweeps_with_new_frames = 3;

  /// A step's motion, over which discrete gradients are taken.
  struct Segment {
    Input q0, q1;
  };

  /// Markers of a block. A beach tilts its blocks whole: small ones. Rows that come from memory come sooner in long
  /// stretches; 2048 markers of all rows still fit in a second cache.
  [[nodiscard]] std::ptrdiff_t block_size() const { return size_ < long_channel ? 256 : 2048; }
  [[nodiscard]] std::ptrdiff_t blocks() const { return (size_ + block_size() - 1) / block_size(); }
  [[nodiscard]] Range markers_of(std::ptrdiff_t block) const;
  /// Cells that begin at the block's markers.
  [[nodiscard]] Range cells_of(std::ptrdiff_t block) const;
  [[nodiscard]] bool level(std::ptrdiff_t block) const { return level_[static_cast<std::size_t>(block)] != 0; }

  /// loop(level, cells) over the cells of a block.
  template <class Loop>
  void over_cells(std::ptrdiff_t block, const Loop& loop) const {
    const Range cells = cells_of(block);
    const bool last_open = block + 1 == blocks() && !channel_.periodic();
    const bool next_level = last_open || level((block + 1) % blocks());
    if (!level(block)) {
      loop(false, cells);
    } else if (next_level || cells.first == cells.last) {
      loop(true, cells);
    } else {  // the last cell ends at a marker that has a frame
      loop(true, Range{cells.first, cells.last - 1});
      loop(false, Range{cells.last - 1, cells.last});
    }
  }

  void weigh(const Markers& initial);
  [[nodiscard]] double cell_width(Input q, std::size_t j) const;
  [[nodiscard]] double dispersion_energy_factor(std::size_t cell) const;

  /// What a thread needs for itself, of one block.
  struct Desk {
    Bed bed;  // of configurations that are not linearised; begins with the block
    std::vector<double> slope;
    std::vector<double> force_x, force_y;  // of the block and the marker after it
    Smallest found{};
    mechanics::SweepChange change{};
  };

  /// Elevation and frames of a block at places x, from place `begin` of the bed on; returns whether it is level. Throws
  /// mechanics::Infeasible.
  bool sample(std::ptrdiff_t block, const double* x, Bed& bed, std::ptrdiff_t begin, std::vector<double>& slope) const;
  /// to = from + h S u for the markers of a block, with the frames at `from`.
  void move_block(std::ptrdiff_t block, Input from, Input u, double h, double* to_x, double* to_y, Desk& desk) const;
  void place_between(std::ptrdiff_t block, Input q0, Input q1);
  [[nodiscard]] double release_at_end(std::ptrdiff_t marker, double sign) const;
  [[nodiscard]] Forces forces() { return {rows_.force_x.row(), rows_.force_y.row()}; }
  void mean_bed(std::ptrdiff_t block, Input q0, Input q1, bool new_frames, Desk& desk);
  [[nodiscard]] Frame end_frame(End end, Frame frame, double slope) const;

  void prepare_losses();
  void place_at(Input q);
  bool find_fronts(Input u);
  [[nodiscard]] bool unresolved() const;
  void exchange_momentum(double h, Output u);
  template <class PairFactor>
  void exchange(const std::vector<double>& inertia, Output u, const PairFactor& pair_factor);
  void take_friction(double h, Output u, Losses& lost);
  void project_rates(Output u);

  void close(std::ptrdiff_t block, const Segment* segment);
  void measure(const Segment* segment);
  void require_sound();
  void assemble_and_factor();

  [[nodiscard]] bool two_threads() const;
  template <class Prepare>
  void assemble_from_both_ends(double h, Input rates, Input target, const Segment* segment, const Prepare& prepare);
  template <class Use>
  void substitute_from_the_middle(const Use& use);
  void assemble_block(std::ptrdiff_t block, double h, Input rates, const double* target, const Segment* segment,
                      Desk& desk);

  void gather_forces(Interval when);
  void add_dispersion_forces(Input q0, Input q1);
  void add_pressure_forces(double time);
  void add_cell_forces();

  Channel channel_;
  Forcing forcing_;
  std::size_t n_;
  std::size_t cells_;
  std::ptrdiff_t size_;  // n_ as loops count
  Rows rows_;
  std::vector<char> level_;  // of blocks
  Weights weights_;
  std::vector<double> mass_, rest_volume_;
  std::vector<double> inertia_p_, inertia_r_;  // m and alpha m; 0 where an end allows no motion
  std::vector<double> dispersion_weight_;      // of cells, with density and gravity
  std::vector<double> along_, across_;         // body forces per unit mass
  GhostedArray push_x_, push_y_;               // of a cell on its right marker, and reversed on its left one
  mutable GhostedArray p_, r_, impulse_;
  mutable std::array<Desk, 2> desks_;  // of the two ends
  linear::TwoEndedTridiagonal matrix_;
  linear::TwoEndedSweep sweep_;
  std::optional<BreakingFronts> fronts_;
  // Of losses; empty without.
  std::vector<double> velocity_x_, velocity_y_, still_;
  std::vector<double> rates_, friction_rate_, mobility_, loss_impulse_;
  std::vector<double> pair_diagonal_, pair_coupling_;
  linear::TwoEndedTridiagonal pairs_;
  double shore_left_ = 0;  // initial places of the ends, where the rest energy
                           // of their bottom is counted from
  double shore_right_ = 0;
  double smallest_depth_ = 0;
  long solves_ = 0;
};

}  // namespace seiche::dispersive_shallow_water_1d
