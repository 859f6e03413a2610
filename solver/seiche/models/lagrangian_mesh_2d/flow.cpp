#include "seiche/models/lagrangian_mesh_2d/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/state.hpp"
#include "seiche/models/lagrangian_mesh_2d/model.hpp"
#include "seiche/models/lagrangian_mesh_2d/rezone.hpp"
#include "seiche/require_that.hpp"

namespace seiche::lagrangian_mesh_2d {

Flow::Flow(Mesh mesh, const Velocity& velocity, Scheme scheme, Settings settings, Forcing forcing, bool smooth_start)
    : lattice::Flow<Model>(scheme) {
  auto model = std::make_unique<Model>(std::move(mesh), settings, std::move(forcing));
  const double stable = longest_stable_step(*model);
  const bool smooth = smooth_start && model->nodes().driven().empty();
  mechanics::State state = model->state(velocity);
  begin_at_first(std::move(model), std::move(state), stable, smooth);
}

void Flow::advance(double tau) {
  mechanics::require_step(tau);
  rezone_where_due();
  step(tau);
}

void Flow::keep_upright(double drift) {
  require_within("drift", drift, 1e-6, 2);
  require_that(!model_->forcing().body_force, "a rezoned mesh with a body force; allowed: none");
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
  const double stable = longest_stable_step(*model);
  mechanics::State state = model->state(now.velocity, state_.time);
  state.steps = state_.steps;
  begin(std::move(model), std::move(state), stable);
  rezoning_.lost += before - energy();
}

}  // namespace seiche::lagrangian_mesh_2d

template class seiche::lattice::Flow<seiche::lagrangian_mesh_2d::Model>;
