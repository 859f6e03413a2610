#include "seiche/models/overlapping_particles/flow.hpp"

#include <stdexcept>
#include <utility>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/state.hpp"

namespace seiche::overlapping_particles {

Flow::Flow(Particles particles, const VelocityAt& velocity, Settings settings)
    : model_(std::make_unique<Model>(std::move(particles), std::move(settings))),
      state_(model_->state(velocity)),
      stepper_(std::make_unique<mechanics::OneStep<Model>>(*model_)) {
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
  stepper_->step(state_, tau);
  impulse_ = state_.multipliers;
  for (double& value : impulse_) value *= tau / 2;
  loss_.add(model_->stabilisation_loss(impulse_));
}

void Flow::advance_to(double time, double tau, const std::function<void()>& after_step) {
  mechanics::equal_steps_to(state_, time, tau, after_step, [this](double length) { advance(length); });
}

double Flow::energy() const {
  return model_->kinetic_energy(state_.q, state_.u) + model_->potential_energy(state_.q);
}

void Flow::observe() {
  mechanics::InvariantsLedger& ledger = watch_->ledger();
  mechanics::book_energy(ledger, booked_ - loss_.value());
  booked_ = loss_.value();
  watch_->record(state_);
}

}  // namespace seiche::overlapping_particles

namespace seiche::mechanics {

template class OneStep<overlapping_particles::Model>;
template class Start<overlapping_particles::Model>;
template class InvariantsWatch<overlapping_particles::Model>;

}  // namespace seiche::mechanics
