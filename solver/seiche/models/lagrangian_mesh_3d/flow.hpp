/// A flow of the hexahedral Lagrangian mesh: a mesh of water, stepped by one of the schemes.
///
///     Flow flow(layer_mesh({.begin = 0, .end = 40, .south = 0, .north = 20, .columns = 80, .rows = 40, .layers = 2,
///                           .elevation = [](double x, double y) { return 0.1 * std::exp(-x * x - y * y); }}));
///     while (flow.time() < 20) flow.advance(0.2);
///
/// The first velocities are projected on constant volumes. Throws std::invalid_argument for bad input and Divergence,
/// with time, step and place, when a cell folds, a solver fails or a value is not finite.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/lagrangian_mesh_3d/model.hpp"
#include "seiche/models/plan_lattice/window.hpp"

namespace seiche::lagrangian_mesh_3d {

using mechanics::Scheme;
using mechanics::Stepping;
using mechanics::TimeComposition;
using plan_lattice::Window;

class Flow {
 public:
  /// @param velocity  at the beginning
  /// @param smooth_start  the first velocities of the one-step scheme get the part outside the constraints that keeps
  ///                      its multipliers from alternating (mechanics/start.hpp); not with driven sides or compositions
  explicit Flow(Mesh mesh, const Velocity& velocity = {}, Scheme scheme = {}, Settings settings = {},
                Window window = {}, bool smooth_start = true);

  /// One step of length tau > 0.
  void advance(double tau);
  /// Equal steps of at most tau until `time`, which is hit exactly; after_step is called after each.
  void advance_to(double time, double tau, const std::function<void()>& after_step = {});

  /// No shorter step of the one-step scheme is unstable on the first mesh (stability.hpp).
  [[nodiscard]] double stable_step() const { return stable_step_; }
  /// Steps that were longer than that: a warning, not an error.
  [[nodiscard]] long steps_beyond_stability() const { return beyond_stability_; }

  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] long steps() const { return state_.steps; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const mechanics::State& state() const { return state_; }
  [[nodiscard]] Shape shape() const { return model_->mesh().plan; }
  [[nodiscard]] std::span<const double> x() const { return part(state_.q, 0); }
  [[nodiscard]] std::span<const double> y() const { return part(state_.q, 1); }
  [[nodiscard]] std::span<const double> z() const { return part(state_.q, 2); }
  [[nodiscard]] std::span<const double> u() const { return part(state_.u, 0); }
  [[nodiscard]] std::span<const double> v() const { return part(state_.u, 1); }
  [[nodiscard]] std::span<const double> w() const { return part(state_.u, 2); }
  /// The nodes of the free surface, numbered as in plan: node (i, j) at j (columns + 1) + i.
  [[nodiscard]] std::span<const double> surface_x() const { return top(x()); }
  [[nodiscard]] std::span<const double> surface_y() const { return top(y()); }
  [[nodiscard]] std::span<const double> surface_z() const { return top(z()); }
  /// Mean multipliers of the last two steps: dynamic pressure of the cells at the beginning of the last step [Pa].
  [[nodiscard]] std::vector<double> dynamic_pressure() const { return state_.nodal_multipliers(); }
  /// Columns that a moving window has left behind.
  [[nodiscard]] long shifts() const { return shifts_; }

  /// Shape of the worst corner: 1 at the beginning for boxes, 0 where the mesh folds; a warning below 0.2.
  [[nodiscard]] Corner worst_corner() const { return model_->worst_corner(state_.q); }
  [[nodiscard]] double energy() const;  ///< kinetic and potential, zero for still water [J]
  /// Mass, momenta, energy, volumes since the beginning. Costs several passes: `observe` takes a record. Not with a
  /// moving window (std::logic_error), which loses water behind and gains water ahead.
  void observe();
  [[nodiscard]] const mechanics::InvariantsLedger& ledger() const { return watch_->ledger(); }

 private:
  [[nodiscard]] std::span<const double> part(const std::vector<double>& values, std::size_t index) const {
    const std::size_t n = model_->nodes().size();
    return {values.data() + index * n, n};
  }
  [[nodiscard]] std::span<const double> top(std::span<const double> values) const {
    return values.last(shape().nodes());
  }

  std::unique_ptr<Model> model_;
  mechanics::State state_;
  std::unique_ptr<mechanics::SchemeStepper<Model>> stepper_;
  std::unique_ptr<mechanics::InvariantsWatch<Model>> watch_;
  Window window_;
  bool smooth_start_;
  double stable_step_;
  long beyond_stability_ = 0;
  long shifts_ = 0;
};

}  // namespace seiche::lagrangian_mesh_3d
