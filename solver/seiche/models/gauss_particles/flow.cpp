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

Flow::Flow(Particles particles, std::unique_ptr<FieldSpace> space, const Velocity& velocity, Settings settings,
           Forcing forcing, Stepping stepping)
    : model_(std::move(particles), std::move(space), settings, std::move(forcing)),
      state_(model_.state(velocity)),
      stepping_(stepping),
      one_step_(model_),
      projected_step_(model_),
      watch_(model_, state_) {
  require_that(!settings.surface || stepping != Stepping::dissipative,
               "gravity on the surface with dissipative stepping; allowed: conservative stepping");
  require_that(settings.penalty == 0 || stepping != Stepping::dissipative,
               "penalty = {:g} with dissipative stepping; allowed: 0, or conservative stepping", settings.penalty);
  mechanics::require_state(state_, model_.coordinates(), model_.rates());
}

double Flow::stable_step() const {
  const double h = model_.space().resolution();
  const double gravity = model_.settings().gravity;
  if (!(h > 0) || !(gravity > 0)) return std::numeric_limits<double>::infinity();
  return 2 / std::sqrt(std::numbers::pi * gravity / h);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  require_that(tau <= stable_step(), "tau = {:g} is out of range: at most {:.4g} = 2/sqrt(pi g/h) on this lattice", tau,
               stable_step());
  if (stepping_ == Stepping::conservative) {
    one_step_.step(state_, tau);
  } else {
    projected_step_.step(state_, tau);
  }
  const double entered = model_.work() - model_.penalty_loss();
  watch_.ledger().book("energy", entered - booked_);
  booked_ = entered;
  free_.add(static_cast<double>(model_.space().facts().free_particles), state_.time);
}

std::vector<Point> Flow::markers() const {
  std::vector<Point> markers;
  for (std::size_t k = 0; k < model_.size(); ++k) {
    if (model_.particles().mass[k] == 0) markers.push_back({x()[k], y()[k]});
  }
  return markers;
}

double Flow::energy() const {
  return model_.kinetic_energy(state_.q, state_.u) + model_.potential_energy(state_.q);
}

}  // namespace seiche::gauss_particles

namespace seiche::mechanics {

template class OneStep<gauss_particles::Model>;
template class ProjectedStep<gauss_particles::Model>;
template class Start<gauss_particles::Model>;
template class InvariantsWatch<gauss_particles::Model>;

}  // namespace seiche::mechanics
