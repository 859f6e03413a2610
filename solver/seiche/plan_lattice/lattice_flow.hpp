/// What the flows of waves in three dimensions share: a model on a lattice seen from above, its state, its stepping,
/// its moving window and its ledger. The flows themselves add how they begin.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/model.hpp"
#include "seiche/plan_lattice/sides.hpp"

namespace seiche::plan_lattice {

/// A window on a long tank that follows a wave travelling east.
///
/// Before a step, while the water east of the window is not at rest any more, the west column is dropped and a column
/// at rest appended (shift_east of the models). A wall does best as the west side: a held side is unlike the undeformed
/// lattice that preconditions the solver, and doubles its iterations.
struct Window {
  std::function<double(double time)> reach = {};  ///< x beyond which all is at rest; empty: no window
};

/// Throws std::invalid_argument for a window over a west side that is neither a wall nor held.
void require_movable(const Window& window, const Sides& sides);

/// Nodes keep the normals of the first lattice's walls. Throws std::invalid_argument, with the place, for a window
/// between walls of which one bends. @param x, y  of that lattice
void require_straight_walls(const Window& window, const Sides& sides, Shape shape, std::span<const double> x,
                            std::span<const double> y);

/// Moves the window to where it must be at the state's time, by model.shift_east(state); returns by how many columns.
template <class Model>
long follow(const Window& window, std::size_t columns, Model& model, mechanics::State& state) {
  if (!window.reach) return 0;
  const double reach = window.reach(state.time);
  long shifts = 0;
  while (reach > state.q[columns] + (state.q[columns] - state.q[columns - 1])) {
    model.shift_east(state);
    ++shifts;
  }
  return shifts;
}

/// @tparam Model  a ConstrainedModel with q = (x, y, z of all nodes), u = (their velocities), worst_corner, energies
/// and
///                shift_east
template <class Model>
class LatticeFlow {
 public:
  /// One step of length tau > 0. Throws std::invalid_argument for tau, Divergence; the state is then as before the
  /// step, but that a moving window has moved.
  void advance(double tau) {
    mechanics::require_step(tau);
    shifts_ += follow(window_, shape_.columns, *model_, state_);
    if (state_.steps == 0 && smooth_start_) {
      mechanics::smooth_step(*model_, *stepper_, state_, tau);
    } else {
      stepper_->step(state_, tau);
    }
    if (tau > stable_step_) ++beyond_stability_;
  }
  void arrive(double time) { state_.time = time; }

  /// No shorter step of the one-step scheme is unstable on the first lattice: 2/omega of a mode faster than all of its.
  [[nodiscard]] double stable_step() const { return stable_step_; }
  /// Steps that were longer than that: a warning, not an error.
  [[nodiscard]] long steps_beyond_stability() const { return beyond_stability_; }

  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] long steps() const { return state_.steps; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const mechanics::State& state() const { return state_; }
  [[nodiscard]] Shape shape() const { return shape_; }
  [[nodiscard]] std::span<const double> x() const { return part(state_.q, 0); }
  [[nodiscard]] std::span<const double> y() const { return part(state_.q, 1); }
  [[nodiscard]] std::span<const double> z() const { return part(state_.q, 2); }
  [[nodiscard]] std::span<const double> u() const { return part(state_.u, 0); }
  [[nodiscard]] std::span<const double> v() const { return part(state_.u, 1); }
  [[nodiscard]] std::span<const double> w() const { return part(state_.u, 2); }
  /// Mean multipliers of the last two steps: dynamic pressure at the beginning of the last step, of the cells, or per
  /// unit density at the bottom of the plan model's columns.
  [[nodiscard]] std::vector<double> dynamic_pressure() const { return state_.nodal_multipliers(); }
  /// Columns that a moving window has left behind.
  [[nodiscard]] long shifts() const { return shifts_; }

  /// Shape of the worst corner: 1 at the beginning for equal boxes, 0 where the lattice folds; a warning below 0.2.
  [[nodiscard]] auto worst_corner() const { return model_->worst_corner(state_.q); }
  /// Kinetic and potential, zero for still water.
  [[nodiscard]] double energy() const {
    return model_->kinetic_energy(state_.q, state_.u) + model_->potential_energy(state_.q);
  }
  /// Mass, momenta, energy, volumes since the beginning. Costs several passes: `observe` takes a record. Not with a
  /// moving window (std::logic_error), which loses water behind and gains water ahead.
  void observe() {
    if (window_.reach) throw std::logic_error("what a moving window holds is not conserved");
    watch_->record(state_);
  }
  [[nodiscard]] std::vector<Invariant> invariants() const { return watch_->invariants(state_); }
  [[nodiscard]] const mechanics::InvariantsLedger& ledger() const { return watch_->ledger(); }

 protected:
  struct Beginning {
    mechanics::Scheme scheme = {};
    Window window = {};
    double stable_step = 0;
    bool smooth_start = true;  ///< only for the one-step scheme without composition, and where no side is driven
  };

  /// Projects the first velocities. Throws std::invalid_argument for the window, Divergence.
  LatticeFlow(std::unique_ptr<Model>&& model, mechanics::State state, Shape shape, const Sides& sides, Beginning begin)
      : model_(std::move(model)),
        state_(std::move(state)),
        shape_(shape),
        stepper_(std::make_unique<mechanics::SchemeStepper<Model>>(*model_, begin.scheme)),
        window_(std::move(begin.window)),
        smooth_start_(begin.smooth_start && begin.scheme.stepping != mechanics::Stepping::conservative &&
                      begin.scheme.composition == mechanics::TimeComposition::none),
        stable_step_(begin.stable_step) {
    require_movable(window_, sides);
    require_straight_walls(window_, sides, shape_, x(), y());
    try {
      mechanics::Start(*model_).project(state_);
    } catch (const mechanics::Infeasible& failure) {
      throw Divergence(failure.what(), 0, 0, failure.place());
    }
    watch_ = std::make_unique<mechanics::InvariantsWatch<Model>>(*model_, state_);
  }

  [[nodiscard]] Model& model_to_change() { return *model_; }

 private:
  [[nodiscard]] static std::span<const double> part(const std::vector<double>& values, std::size_t index) {
    const std::size_t n = values.size() / 3;
    return {values.data() + index * n, n};
  }

  std::unique_ptr<Model> model_;
  mechanics::State state_;
  Shape shape_;
  std::unique_ptr<mechanics::SchemeStepper<Model>> stepper_;
  std::unique_ptr<mechanics::InvariantsWatch<Model>> watch_;
  Window window_;
  bool smooth_start_;
  double stable_step_;
  long beyond_stability_ = 0;
  long shifts_ = 0;
};

}  // namespace seiche::plan_lattice
