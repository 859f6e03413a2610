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

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/step_parts.hpp"

namespace seiche::mechanics {

// The index-reduced form of the constrained equations: constraints differentiated twice, multipliers eliminated.
//
// @f[ A(q) \, \lambda = -(J W F + B(u, u)), \qquad \dot{u} = W (F + J^T \lambda), \qquad
//     B(u, v) = \left( \frac{\partial J}{\partial q} \cdot S u \right) v @f]
//
// What Runge-Kutta methods integrate, and the acceleration that the corrected start needs. Not for prescribed nodes:
// their accelerations are not part of the model's interface.
//
// Reference: Hairer & Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), VII.1.

template <ConstrainedModel Model>
requires HasMultipliers<Model>
class IndexReduced {
 public:
  explicit IndexReduced(Model& model) : model_(model) {}

  /// u' at (time, q, u). Leaves the model linearised at q.
  void acceleration(double time, Input q, Input u, Output result) {
    curvature(time, q, u, u);
    std::fill(result.begin(), result.end(), 0.0);
    kick(u, result);
    rates_.resize(model_.constraints());
    model_.constraint_rates(result, rates_);
    for (std::size_t s = 0; s < rates_.size(); ++s) rates_[s] = -(rates_[s] + curvature_[s]);
    multipliers_.assign(rates_.size(), 0.0);
    model_.solve(rates_, multipliers_);
    model_.react(multipliers_, result);
  }

  /// B(u, v) at (time, q). Leaves the model linearised at q. Without the model's own Hessians: central difference of J
  /// along u, exact but for round-off if J is linear in q.
  Input curvature(double time, Input q, Input u, Input v) {
    if constexpr (HasCurvature<Model>) {
      model_.linearise({time, 0}, q);
      curvature_.resize(model_.constraints());
      model_.curvature(u, v, curvature_);
    } else {
      difference(time, q, u, v);
      model_.linearise({time, 0}, q);
    }
    return curvature_;
  }

  [[nodiscard]] Input multipliers() const { return multipliers_; }
  [[nodiscard]] Model& model() { return model_; }

 private:
  /// In which the fastest coordinate goes a small part of a cell, of models that say what a cell is; else of 1.
  double short_time(Input u) const {
    double speed = 0;
    for (const double rate : u) speed = std::max(speed, std::abs(rate));
    double length = relative_step;
    if constexpr (requires { model_.cell_size(); }) length *= model_.cell_size();
    return speed > 0 ? length / speed : length;
  }

  /// By the forces alone: what drags take of velocities that start from zero does not count over a short time.
  void kick(Input u, Output result) const {
    if constexpr (requires { model_.cell_size(); }) {
      const double h = short_time(u);
      model_.kick(h, result);
      for (double& rate : result) rate /= h;
    } else {
      model_.kick(1, result);
    }
  }

  void difference(double time, Input q, Input u, Input v) {
    const double h = short_time(u);
    moved_.resize(q.size());
    // The first linearisation at q fixes S there, so that advance moves along S(q) u in both directions.
    model_.linearise({time, 0}, q);
    ahead_.resize(q.size());
    model_.advance(q, u, h, ahead_);
    model_.advance(q, u, -h, moved_);
    model_.linearise({time, 0}, ahead_);
    curvature_.resize(model_.constraints());
    model_.constraint_rates(v, curvature_);
    model_.linearise({time, 0}, moved_);
    rates_.resize(model_.constraints());
    model_.constraint_rates(v, rates_);
    for (std::size_t s = 0; s < rates_.size(); ++s) curvature_[s] = (curvature_[s] - rates_[s]) / (2 * h);
  }

  static constexpr double relative_step = 6e-6;  // cube root of the machine precision

  Model& model_;
  std::vector<double> curvature_, rates_, multipliers_, moved_, ahead_;
};

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
