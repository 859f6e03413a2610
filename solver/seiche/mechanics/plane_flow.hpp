/// What flows of point masses in a plane share, q = (x of all, y of all), u = (velocities along x, along y): the start,
/// steps to a time, and a ledger in which what a stabilisation takes from the energy, or a feedback of the drift does
/// to it, is booked.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/model_flow.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::mechanics {

template <class Model>
class PlaneFlow : public ModelFlow<Model> {
 public:
  [[nodiscard]] Input x() const { return Input(state_.q).first(state_.q.size() / 2); }
  [[nodiscard]] Input y() const { return Input(state_.q).last(state_.q.size() / 2); }
  [[nodiscard]] Input u() const { return Input(state_.u).first(state_.u.size() / 2); }
  [[nodiscard]] Input v() const { return Input(state_.u).last(state_.u.size() / 2); }
  [[nodiscard]] double kinetic_energy() const { return model_->kinetic_energy(state_.q, state_.u); }  ///< [J/m]
  [[nodiscard]] double potential_energy() const { return model_->potential_energy(state_.q); }        ///< [J/m]
  /// What the stabilisation took from the water since the beginning [J/m]; never falls.
  [[nodiscard]] double stabilisation_loss() const { return loss_.value(); }
  /// What the feedback of the drift did to it, of either sign [J/m].
  [[nodiscard]] double drift_work() const { return work_.value(); }
  /// Largest defect of a constraint.
  [[nodiscard]] double largest_drift() const {
    std::vector<double> drift(model_->constraints());
    model_->constraint_values(state_.q, drift);
    return worst(drift);
  }

  [[nodiscard]] static double stable_step() { return std::numeric_limits<double>::infinity(); }

 protected:
  using ModelFlow<Model>::model_, ModelFlow<Model>::state_, ModelFlow<Model>::watch_;

  /// Projects the first velocities on the constraints. Throws std::invalid_argument where the model cannot start.
  PlaneFlow(std::unique_ptr<Model> model, const VelocityAt& velocity) {
    State state = model->state(velocity);
    this->begin_at_first(std::move(model), std::move(state));
  }

  /// What a step took by stabilisation, and what the feedback did.
  void book(double loss, double work) {
    loss_.add(loss);
    work_.add(work);
    watch_->ledger().book("energy", work - loss);
  }

  CompensatedSum loss_, work_;
  std::vector<double> impulse_;  // of the multipliers
};

/// Stepped by Frank's one-step scheme.
template <class Model>
class OneStepFlow : public PlaneFlow<Model> {
 public:
  /// Throws Divergence, with time, step and place, where the model is Infeasible or a value not finite.
  void advance(double tau) override {
    require_step(tau);
    if (feedback_ > 0) {
      drift_.resize(this->model_->constraints());
      this->model_->constraint_values(this->state_.q, drift_);
    }
    stepper_->step(this->state_, tau);
    auto& impulse = this->impulse_;
    impulse = this->state_.multipliers;
    for (double& value : impulse) value *= tau / 2;
    // The multipliers work by tau lambda.(G u) = 2 mu.target - the loss.
    CompensatedSum work;
    for (std::size_t s = 0; s < drift_.size(); ++s) work.add(-2 * feedback_ / tau * impulse[s] * drift_[s]);
    this->book(this->model_->stabilisation_loss(impulse), work.value());
  }

 protected:
  /// @param drift_feedback  share of the drift of the constraints that a step takes back, in [0, 1]
  OneStepFlow(std::unique_ptr<Model> model, const VelocityAt& velocity, double drift_feedback = 0)
      : PlaneFlow<Model>(std::move(model), velocity), feedback_(drift_feedback) {
    require_within("drift_feedback", drift_feedback, 0, 1);
    typename OneStep<Model>::Settings settings;
    if (drift_feedback > 0) settings = {.drift_feedback = true, .drift_share = drift_feedback};
    stepper_ = std::make_unique<OneStep<Model>>(*this->model_, settings);
  }

 private:
  double feedback_;
  std::unique_ptr<OneStep<Model>> stepper_;
  std::vector<double> drift_;  // before the step
};

}  // namespace seiche::mechanics
