#include "seiche/models/dirichlet_mesh/flow.hpp"

#include <stdexcept>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::dirichlet_mesh {

namespace {

using Step = mechanics::OneStep<Model>;

Step::Settings step_settings(double drift_feedback) {
  require_within("drift_feedback", drift_feedback, 0, 1);
  if (drift_feedback == 0) return {};
  return {.drift_feedback = true, .drift_share = drift_feedback};
}

}  // namespace

Flow::Flow(const Mesh& mesh, const VelocityAt& velocity, Settings settings, double drift_feedback)
    : model_(std::make_unique<Model>(mesh, settings)),
      state_(model_->state(velocity)),
      drift_feedback_(drift_feedback),
      stepper_(std::make_unique<Step>(*model_, step_settings(drift_feedback))) {
  try {
    mechanics::Start(*model_).project(state_);
  } catch (const mechanics::Infeasible& failure) {
    throw std::invalid_argument(failure.what());
  }
  watch_ = std::make_unique<mechanics::InvariantsWatch<Model>>(*model_, state_);
}

Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;
Flow& Flow::operator=(Flow&&) noexcept = default;

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  if (drift_feedback_ > 0) {
    drift_.resize(model_->constraints());
    model_->constraint_values(state_.q, drift_);
  }
  stepper_->step(state_, tau);
  book(tau);
}

void Flow::book(double tau) {
  impulse_ = state_.multipliers;
  for (double& value : impulse_) value *= tau / 2;
  loss_.add(model_->stabilisation_loss(impulse_));
  // The multipliers work by tau lambda.(G u) = 2 mu.target - the loss.
  for (std::size_t s = 0; s < drift_.size(); ++s) work_.add(-2 * drift_feedback_ / tau * impulse_[s] * drift_[s]);
}

void Flow::advance_to(double time, double tau, const std::function<void()>& after_step) {
  mechanics::equal_steps_to(state_, time, tau, after_step, [this](double length) { advance(length); });
}

double Flow::energy() const {
  return model_->kinetic_energy(state_.q, state_.u) + model_->potential_energy(state_.q);
}

double Flow::largest_drift() const {
  std::vector<double> drift(model_->constraints());
  model_->constraint_values(state_.q, drift);
  return worst(drift);
}

void Flow::observe() {
  mechanics::InvariantsLedger& ledger = watch_->ledger();
  const double booked = work_.value() - loss_.value();
  mechanics::book_energy(ledger, booked - booked_);
  booked_ = booked;
  watch_->record(state_);
}

}  // namespace seiche::dirichlet_mesh

namespace seiche::mechanics {

template class OneStep<dirichlet_mesh::Model>;

}  // namespace seiche::mechanics
