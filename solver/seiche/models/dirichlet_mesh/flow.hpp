/// A flow of the Dirichlet mesh: water in cells, stepped by Frank's one-step scheme.
///
///     Flow flow(free_lagrangian::layer_mesh({.begin = 0, .end = 3, .columns = 24, .rows = 8}),
///               [](Point r) { return Point{0.01 * std::sin(r.x), 0}; });
///     while (flow.time() < 20) flow.advance(0.05);
///
/// The first velocities are projected on constant areas. What the stabilisation and the feedback of the drift do to the
/// energy is booked: energy() + stabilisation_loss() - drift_work() is kept to round-off without gravity, and to
/// O(tau^2) with it. Throws std::invalid_argument for bad input, a singular mesh without stabilisation among it, and
/// Divergence, with time, step and place, when the mesh tangles or a value is not finite.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/free_lagrangian/cell_water.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/models/dirichlet_mesh/model.hpp"

namespace seiche::dirichlet_mesh {

class Flow {
 public:
  /// @param drift_feedback  share of the drift of the areas that a step takes back, in [0, 1]; 0.2 is enough
  explicit Flow(const Mesh& mesh, const VelocityAt& velocity = {}, Settings settings = {}, double drift_feedback = 0);
  ~Flow();
  Flow(Flow&&) noexcept;
  Flow& operator=(Flow&&) noexcept;

  /// One step of length tau > 0. A step that fails leaves the state as it was.
  void advance(double tau);
  /// Equal steps of at most tau until `time`, which is hit exactly; after_step is called after each.
  void advance_to(double time, double tau, const std::function<void()>& after_step = {});

  [[nodiscard]] double time() const { return state_.time; }
  [[nodiscard]] long steps() const { return state_.steps; }
  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const mechanics::State& state() const { return state_; }
  [[nodiscard]] std::span<const double> x() const { return part(state_.q, 0); }
  [[nodiscard]] std::span<const double> y() const { return part(state_.q, 1); }
  [[nodiscard]] std::span<const double> u() const { return part(state_.u, 0); }
  [[nodiscard]] std::span<const double> v() const { return part(state_.u, 1); }
  /// p + rho g y of the cells, mean of the last two steps [Pa].
  [[nodiscard]] std::vector<double> dynamic_pressure() const { return state_.nodal_multipliers(); }

  [[nodiscard]] double energy() const;  ///< kinetic and potential [J/m]
  /// What the stabilisation took from the water since the beginning [J/m]; never falls.
  [[nodiscard]] double stabilisation_loss() const { return loss_.value(); }
  /// What the feedback of the drift did to it, of either sign [J/m].
  [[nodiscard]] double drift_work() const { return work_.value(); }
  /// Largest |A_i - m_i/rho| [m^2].
  [[nodiscard]] double largest_drift() const;
  /// A warning when the smallest angle falls below a few degrees.
  [[nodiscard]] MeshQuality quality() const { return model_->quality(state_.q); }
  [[nodiscard]] long flips() const { return model_->triangulation().flips(); }

  /// Mass, momenta, energy with what was booked, areas since the beginning: takes a record.
  void observe();
  [[nodiscard]] const mechanics::InvariantsLedger& ledger() const { return watch_->ledger(); }

 private:
  [[nodiscard]] std::span<const double> part(const std::vector<double>& values, std::size_t index) const {
    const std::size_t n = model_->nodes();
    return {values.data() + index * n, n};
  }
  void book(double tau);

  std::unique_ptr<Model> model_;
  mechanics::State state_;
  double drift_feedback_;
  std::unique_ptr<mechanics::OneStep<Model>> stepper_;
  std::unique_ptr<mechanics::InvariantsWatch<Model>> watch_;
  CompensatedSum loss_, work_;
  double booked_ = 0;            // of the ledger's energy
  std::vector<double> drift_;    // before the step
  std::vector<double> impulse_;  // of the multipliers
};

}  // namespace seiche::dirichlet_mesh

// The integrator of the model, compiled once and not in every file that steps it.
namespace seiche::mechanics {

extern template class OneStep<dirichlet_mesh::Model>;

}  // namespace seiche::mechanics
