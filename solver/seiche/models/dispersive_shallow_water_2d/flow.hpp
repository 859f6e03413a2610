/// A flow of the plan model: a lattice of water columns, stepped by one of the schemes.
///
///     Flow flow(rectangular_lattice({.begin = 0, .end = 40, .south = 0, .north = 20, .columns = 80, .rows = 40,
///                                    .elevation = [](double x, double y) { return 0.1 * std::exp(-x * x - y * y);
///                                    }}));
///     while (flow.time() < 20) flow.advance(0.2);
///
/// The first velocities are projected on constant volumes. Throws std::invalid_argument for bad input and Divergence,
/// with time, step and place, when a cell folds, a marker touches the bottom or leaves it, a solver fails or a value is
/// not finite.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"
#include "seiche/models/plan_lattice/window.hpp"

namespace seiche::dispersive_shallow_water_2d {

using mechanics::Scheme;
using mechanics::Stepping;
using mechanics::TimeComposition;
using plan_lattice::Window;

class Flow {
 public:
  /// @param velocity  at the beginning
  /// @param smooth_start  the first velocities of the one-step scheme get the part outside the constraints that keeps
  ///                      its multipliers from alternating (mechanics/start.hpp); not with driven sides or compositions
  explicit Flow(Lattice lattice, const VelocityAt& velocity = {}, Scheme scheme = {}, Settings settings = {},
                Forcing forcing = {}, Window window = {}, bool smooth_start = true);

  /// One step of length tau > 0.
  void advance(double tau);
  /// Equal steps of at most tau until `time`, which is hit exactly; after_step is called after each.
  void advance_to(double time, double tau, const std::function<void()>& after_step = {});

  /// No longer step of the one-step scheme is unstable: 2/omega of a mode faster than all modes of the first lattice.
  [[nodiscard]] double stable_step() const { return stable_step_; }
  /// Steps that were longer than that: a warning, not an error.
  [[nodiscard]] long steps_beyond_stability() const { return beyond_stability_; }

  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] long steps() const { return state_.steps; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const mechanics::State& state() const { return state_; }
  [[nodiscard]] Shape shape() const { return model_->shape(); }
  [[nodiscard]] std::span<const double> x() const { return part(state_.q, 0); }
  [[nodiscard]] std::span<const double> y() const { return part(state_.q, 1); }
  [[nodiscard]] std::span<const double> z() const { return part(state_.q, 2); }
  [[nodiscard]] std::span<const double> u() const { return part(state_.u, 0); }
  [[nodiscard]] std::span<const double> v() const { return part(state_.u, 1); }
  [[nodiscard]] std::span<const double> w() const { return part(state_.u, 2); }
  /// Mean multipliers of the last two steps: pressure at the bottom less the hydrostatic one, per unit density, at the
  /// beginning of the last step.
  [[nodiscard]] std::vector<double> dynamic_pressure() const { return state_.nodal_multipliers(); }
  /// Columns that a moving window has left behind.
  [[nodiscard]] long shifts() const { return shifts_; }

  /// Shape of the worst corner: 1 at the beginning for equal rectangles, 0 where the lattice folds.
  [[nodiscard]] Corner worst_corner() const { return model_->worst_corner(state_.q); }
  [[nodiscard]] double energy() const;  ///< kinetic and potential, per unit density, zero for still water
  /// Mass, momenta, energy, volumes since the beginning. Costs several passes: `observe` takes a record. Not with a
  /// moving window (std::logic_error), which loses water behind and gains water ahead.
  void observe();
  [[nodiscard]] const mechanics::InvariantsLedger& ledger() const { return watch_->ledger(); }

 private:
  [[nodiscard]] std::span<const double> part(const std::vector<double>& values, std::size_t index) const {
    const std::size_t n = model_->nodes();
    return {values.data() + index * n, n};
  }

  std::unique_ptr<Model> model_;
  mechanics::State state_;
  mechanics::State before_;  // the last step, over uneven bottoms
  std::unique_ptr<mechanics::SchemeStepper<Model>> stepper_;
  std::unique_ptr<mechanics::InvariantsWatch<Model>> watch_;
  Window window_;
  bool smooth_start_;
  double stable_step_;
  long beyond_stability_ = 0;
  long shifts_ = 0;
};

}  // namespace seiche::dispersive_shallow_water_2d
