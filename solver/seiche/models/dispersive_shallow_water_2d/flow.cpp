#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/equal_steps.hpp"

namespace seiche::dispersive_shallow_water_2d {

namespace {

/// 2/omega with omega^2 = g H K^2/(1 + alpha H^2 K^2), K^2 = 4/h1^2 + 4/h2^2 of the narrowest cell: K is larger than
/// that of any mode, and the factor G < 1 of the dispersion law is left out.
double surely_stable_step(const Model& model) {
  const Lattice& lattice = model.lattice();
  const Settings& settings = model.settings();
  double fastest = 0;
  for (std::size_t cell = 0; cell < lattice.shape.cells(); ++cell) {
    const auto [c0, c1, c2, c3] = lattice.shape.corners(cell);
    const double h1 = std::hypot(lattice.x[c1] - lattice.x[c0], lattice.y[c1] - lattice.y[c0]);
    const double h2 = std::hypot(lattice.x[c3] - lattice.x[c0], lattice.y[c3] - lattice.y[c0]);
    const double square = 4 / (h1 * h1) + 4 / (h2 * h2);
    const double depth =
        lattice.bottom ? -lattice.bottom->slope(lattice.x[c0], lattice.y[c0]).elevation : lattice.depth;
    if (!(depth > 0)) continue;
    fastest = std::max(fastest, settings.gravity * depth * square / (1 + settings.inertia * depth * depth * square));
  }
  return fastest > 0 ? 2 / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

}  // namespace

Flow::Flow(Lattice lattice, const VelocityAt& velocity, Scheme scheme, Settings settings, Forcing forcing,
           Window window, bool smooth_start)
    : model_(std::make_unique<Model>(std::move(lattice), settings, std::move(forcing))),
      state_(model_->state(velocity)),
      stepper_(std::make_unique<mechanics::SchemeStepper<Model>>(*model_, scheme)),
      window_(std::move(window)),
      smooth_start_(smooth_start && scheme.stepping != Stepping::conservative &&
                    scheme.composition == TimeComposition::none && !model_->has_driven_sides()),
      stable_step_(surely_stable_step(*model_)) {
  plan_lattice::require_movable(window_, model_->lattice().sides);
  if (window_.reach && model_->has_shoreline()) {
    throw std::invalid_argument("a moving window with a shoreline; allowed: one of them");
  }
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
  if (!model_->lattice().bottom) {
    stepper_->step(state_, tau);
    return;
  }
  // A marker may leave an uneven bottom, or touch it, at the end of a step, when the state has changed.
  before_ = state_;
  try {
    stepper_->step(state_, tau);
  } catch (const Divergence&) {
    state_ = before_;
    throw;
  }
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

}  // namespace seiche::dispersive_shallow_water_2d
