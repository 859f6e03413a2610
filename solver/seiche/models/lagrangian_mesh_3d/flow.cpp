#include "seiche/models/lagrangian_mesh_3d/flow.hpp"

#include <stdexcept>
#include <utility>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/equal_steps.hpp"
#include "seiche/models/lagrangian_mesh_3d/stability.hpp"

namespace seiche::lagrangian_mesh_3d {

Flow::Flow(Mesh mesh, const Velocity& velocity, Scheme scheme, Settings settings, Window window, bool smooth_start)
    : model_(std::make_unique<Model>(std::move(mesh), settings)),
      state_(model_->state(velocity)),
      stepper_(std::make_unique<mechanics::SchemeStepper<Model>>(*model_, scheme)),
      window_(std::move(window)),
      smooth_start_(smooth_start && scheme.stepping != Stepping::conservative &&
                    scheme.composition == TimeComposition::none && model_->nodes().driven().empty()),
      stable_step_(surely_stable_step(*model_)) {
  plan_lattice::require_movable(window_, model_->mesh().sides);
  try {
    mechanics::Start(*model_).project(state_);
  } catch (const mechanics::Infeasible& failure) {
    throw Divergence(failure.what(), 0, 0, failure.place());
  }
  watch_ = std::make_unique<mechanics::InvariantsWatch<Model>>(*model_, state_);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  if (tau > stable_step_) ++beyond_stability_;
  if (state_.steps == 0 && smooth_start_) mechanics::Start(*model_).project_to_smooth(state_, tau);
  shifts_ += plan_lattice::follow(window_, shape().columns, *model_, state_);
  stepper_->step(state_, tau);
}

void Flow::advance_to(double time, double tau, const std::function<void()>& after_step) {
  mechanics::equal_steps_to(
      state_, time, tau, [this](double length) { advance(length); }, after_step);
}

double Flow::energy() const {
  return model_->kinetic_energy(state_.q, state_.u) + model_->potential_energy(state_.q);
}

void Flow::observe() {
  if (window_.reach) throw std::logic_error("what a moving window holds is not conserved");
  watch_->record(state_);
}

}  // namespace seiche::lagrangian_mesh_3d
