/// Initial velocities for the one-step scheme, which reflects what they have outside the constraints and never damps
/// it.
///
/// The residual w^n = J(q^n) u^n obeys w^{n+1} + w^n = (tau/2)[B(u^{n+1},u^{n+1}) - B(u^n,u^n)] for quadratic
/// constraints.
///
///     w^0 arbitrary                   multipliers alternate by (2/tau) A^-1 w, for ever: never start so
///     w^0 = 0                         project: they alternate by O(tau)
///     w^0 = w_s = (tau^2/2) B(u, u')  project, project_to_smooth: by O(tau^3)
///
/// In runs of 1e5 steps and more the alternation can grow from round-off although energy and momenta stay exact;
/// project_to_smooth now and then keeps the momenta exact and costs next to nothing in energy.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 1.
#pragma once

#include <utility>
#include <vector>

#include "seiche/mechanics/index_reduced.hpp"
#include "seiche/mechanics/step_parts.hpp"

namespace seiche::mechanics {

template <ConstrainedModel Model>
class Start {
 public:
  explicit Start(Model& model) : model_(model), projection_(model) {}

  /// u <- projection of u on J u = 0 at the state's configuration. Throws std::invalid_argument for a bad state.
  void project(State& state) {
    require_state(state, model_.coordinates(), model_.rates());
    model_.linearise({state.time, 0}, state.q);
    restore(state, {});
  }

  /// u <- projection of u on J u = w_s for steps of length tau, of a velocity that is projected already.
  void project_to_smooth(State& state, double tau) requires HasMultipliers<Model> {
    IndexReduced<Model> form(model_);
    acceleration_.resize(state.u.size());
    form.acceleration(state.time, state.q, state.u, acceleration_);
    const Input curvature = form.curvature(state.time, state.q, state.u, acceleration_);
    target_.assign(curvature.begin(), curvature.end());
    for (double& w : target_) w *= tau * tau / 2;
    restore(state, target_);
  }

 private:
  void restore(State& state, Input target) {
    impulse_.assign(constraint_count(model_), 0.0);
    projection_.project(state.u, target, impulse_);
    const std::size_t bad = first_not_finite(state.u);
    if (bad < state.u.size()) throw_not_finite(state, state.u, place_of_rate(model_, bad));
  }

  Model& model_;
  Projection<Model> projection_;
  std::vector<double> impulse_;
  std::vector<double> acceleration_;
  std::vector<double> target_;
};

/// The first step, by a stepper of the model, with project_to_smooth before it. A throw leaves the state as it was.
template <ConstrainedModel Model, class Stepper>
void smooth_step(Model& model, Stepper& stepper, State& state, double tau) {
  State next = state;
  StepParts<Model>::guarded(state, [&] { Start(model).project_to_smooth(next, tau); });
  stepper.step(next, tau);
  state = std::move(next);
}

}  // namespace seiche::mechanics
