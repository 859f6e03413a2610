/// A flow of overlapping particles, stepped by Frank's one-step scheme.
///
///     Flow flow(staggered_disc(1, 0.1), [](Point r) { return Point{r.x, -r.y}; });
///     while (flow.time() < 1) flow.advance(0.02);
///
/// The first velocities are projected on constant masses of the control volumes, which takes some per cent of them next
/// to free surfaces. What a stabilisation takes from the energy is booked. Throws std::invalid_argument for bad input,
/// singular configurations among it, and Divergence, with time, step and place, when one comes up on the way, a
/// particle goes through a wall, or a value is not finite.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/models/overlapping_particles/model.hpp"

namespace seiche::overlapping_particles {

class Flow {
 public:
  explicit Flow(Particles particles, const VelocityAt& velocity = {}, Settings settings = {});
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

  [[nodiscard]] double energy() const;  ///< kinetic and potential [J/m]
  /// What the stabilisation took from the water since the beginning [J/m]; never falls.
  [[nodiscard]] double stabilisation_loss() const { return loss_.value(); }

  /// Mass, momenta, energy with what was booked, masses of the control volumes since the beginning: takes a record.
  void observe();
  [[nodiscard]] const mechanics::InvariantsLedger& ledger() const { return watch_->ledger(); }

 private:
  [[nodiscard]] std::span<const double> part(const std::vector<double>& values, std::size_t index) const {
    const std::size_t n = model_->size();
    return {values.data() + index * n, n};
  }

  std::unique_ptr<Model> model_;
  mechanics::State state_;
  std::unique_ptr<mechanics::OneStep<Model>> stepper_;
  std::unique_ptr<mechanics::InvariantsWatch<Model>> watch_;
  CompensatedSum loss_;
  double booked_ = 0;            // of the ledger's energy
  std::vector<double> impulse_;  // of the multipliers
};

}  // namespace seiche::overlapping_particles

// The integrators of the model, compiled once and not in every file that steps it.
namespace seiche::mechanics {

extern template class OneStep<overlapping_particles::Model>;
extern template class Start<overlapping_particles::Model>;
extern template class InvariantsWatch<overlapping_particles::Model>;

}  // namespace seiche::mechanics
