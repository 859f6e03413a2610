#include "seiche/models/gauss_particles/flow.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/require_that.hpp"

namespace seiche::gauss_particles {

Flow::Flow(Particles particles, std::unique_ptr<FieldSpace> space, const mechanics::VelocityAt& velocity,
           Settings settings, Forcing forcing, Stepping stepping)
    : stepping_(stepping) {
  require_that(!settings.surface || stepping != Stepping::dissipative,
               "gravity on the surface with dissipative stepping; allowed: conservative stepping");
  require_that(settings.penalty == 0 || stepping != Stepping::dissipative,
               "penalty = {:g} with dissipative stepping; allowed: 0, or conservative stepping", settings.penalty);
  auto model = std::make_unique<Model>(std::move(particles), std::move(space), settings, std::move(forcing));
  mechanics::State state = model->state(velocity);
  mechanics::require_state(state, model->coordinates(), model->rates());
  take(std::move(model), std::move(state));
  one_step_ = std::make_unique<mechanics::OneStep<Model>>(*model_);
  projected_step_ = std::make_unique<mechanics::ProjectedStep<Model>>(*model_);
}

double Flow::stable_step() const {
  const double h = model_->space().resolution();
  const double gravity = model_->settings().gravity;
  if (!(h > 0) || !(gravity > 0)) return std::numeric_limits<double>::infinity();
  return 2 / std::sqrt(std::numbers::pi * gravity / h);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  require_that(tau <= stable_step(), "tau = {:g} is out of range: at most {:.4g} = 2/sqrt(pi g/h) on this lattice", tau,
               stable_step());
  if (stepping_ == Stepping::conservative) {
    one_step_->step(state_, tau);
  } else {
    projected_step_->step(state_, tau);
  }
  const double entered = model_->work() - model_->penalty_loss();
  watch_->ledger().book("energy", entered - booked_);
  booked_ = entered;
  free_.add(static_cast<double>(model_->space().facts().free_particles), state_.time);
}

std::vector<Point> Flow::markers() const {
  std::vector<Point> markers;
  for (std::size_t k = 0; k < model_->size(); ++k) {
    if (model_->particles().mass[k] == 0) markers.push_back({x()[k], y()[k]});
  }
  return markers;
}

}  // namespace seiche::gauss_particles

template class seiche::mechanics::OneStep<seiche::gauss_particles::Model>;
template class seiche::mechanics::ProjectedStep<seiche::gauss_particles::Model>;
template class seiche::mechanics::Start<seiche::gauss_particles::Model>;
template class seiche::mechanics::InvariantsWatch<seiche::gauss_particles::Model>;
