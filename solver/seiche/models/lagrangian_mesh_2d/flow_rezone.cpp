// Flow: the mesh is rezoned.
#include <stdexcept>

#include "seiche/divergence.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/remap.hpp"
#include "seiche/models/lagrangian_mesh_2d/stability.hpp"

namespace seiche::lagrangian_mesh_2d {

void Flow::keep_upright(double drift) {
  require_within("drift", drift, 1e-6, 2);
  if (model_->forcing().body_force) throw std::invalid_argument("a rezoned mesh with a body force; allowed: none");
  upright_ = std::make_unique<const UprightColumns>(model_->mesh());
  drift_ = drift;
}

void Flow::rezone_where_due() {
  if (!upright_) return;
  const UprightColumns::Places places = upright_->places(state_.q);
  if (!(upright_->drift(state_.q, places) > drift_)) return;
  try {
    rezone(places);
    ++rezoning_.done;
  } catch (const mechanics::Infeasible&) {
    ++rezoning_.refused;
  }
}

void Flow::rezone(const UprightColumns::Places& places) {
  Remapped now = remap(*model_, state_.q, state_.u, places.x, places.y);
  const double before = energy();
  auto model = std::make_unique<Model>(std::move(now.mesh), model_->settings(), model_->forcing());
  mechanics::State state = model->state(now.velocity, state_.time);
  mechanics::Start(*model).project(state);
  state.steps = state_.steps;
  watch_.reset();
  stepper_ = std::make_unique<mechanics::SchemeStepper<Model>>(*model, scheme_);
  watch_ = std::make_unique<mechanics::InvariantsWatch<Model>>(*model, state);
  model_ = std::move(model);
  state_ = std::move(state);
  stable_step_ = longest_stable_step(*model_);
  fresh_ = true;
  rezoning_.lost += before - energy();
}

}  // namespace seiche::lagrangian_mesh_2d
