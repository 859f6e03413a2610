/// Frank's conservative one-step scheme for constrained systems, one solve per step (Frank 1994, formulas 4, 5).
///
/// @f[ \tilde{q} = q^n + \frac{\tau}{2} S(q^n) \, u^n \tag{4.1} @f]
/// @f[ u^* = u^n + \frac{\tau}{2} W F(\tilde{q}), \qquad
///     \tilde{u} = \text{projection of } u^* \text{ on } J(\tilde{q}) \, \tilde{u} = 0 \tag{5} @f]
/// @f[ q^{n+1} = q^n + \tau S(\tilde{q}) \, \tilde{u}, \qquad u^{n+1} = 2 \tilde{u} - u^n \tag{4.2} @f]
///
/// Drift, kick, drift: second order, time-reversible, stable for omega tau < 2. Exact, for any multipliers however
/// loosely solved: linear and angular momentum of a free body. Exact to tau lambda.(J u~): energy, if Pi is linear. For
/// constraints quadratic in q: f_s(q^n) - (tau^2/8) u^n.(Hessian of f_s) u^n. Bounded and O(tau^2): the energy for
/// other potentials, and the constraints themselves; drift_feedback makes the latter O(tau^3).
///
/// The scheme reflects the part of u normal to the constraints, it never damps it: project the first velocity
/// (start.hpp), and average multipliers over two steps (State::nodal_multipliers).
///
/// When not to use it: where energy of a nonlinear potential or volumes must be exact, see conservative_step.hpp.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 1.
#pragma once

#include <limits>
#include <vector>

#include "seiche/mechanics/step_parts.hpp"
#include "seiche/require.hpp"

namespace seiche::mechanics {

template <ConstrainedModel Model>
class OneStep {
 public:
  struct Settings {
    bool drift_feedback = false;  ///< J u~ = -f(q^n)/tau instead of 0: the constraints' drift no longer accumulates
    double drift_share = 1;       ///< of the drift that a step takes back, in (0, 1]
  };

  /// @param model  must outlive the stepper
  /// Throws std::invalid_argument for settings that the model does not support.
  explicit OneStep(Model& model, Settings settings = {})
      : model_(model), parts_(model, settings.drift_feedback, settings.drift_share) {
    require_within("drift_share", settings.drift_share, std::numeric_limits<double>::min(), 1);
  }

  /// One step, tau > 0. Throws std::invalid_argument for tau, Divergence for infeasible configurations and rates that
  /// are not finite; the state is then as before the step, whatever was thrown.
  void step(State& state, double tau) {
    require_step(tau);
    substep(state, tau);
    ++state.steps;
  }

  /// As step, for any sign of tau and without counting it: the stage of a composition.
  void substep(State& state, double tau) {
    parts_.guarded(state, [&] { take(state, tau); });
  }

 private:
  void take(State& state, double tau) {
    const Interval when{state.time, tau};
    const Input target = parts_.drift_target(state.q, tau);
    if constexpr (FusesStep<Model>) {
      if (model_.fuses_step()) {
        fused_multipliers_.resize(constraint_count(model_));
        model_.fused_step(when, state.q, state.u, target, fused_multipliers_);
        state.next_multipliers().swap(fused_multipliers_);
        parts_.settle(when, state.q, state.u);
        state.earlier_u.clear();
        state.time = when.end();
        return;
      }
    }
    middle_.resize(state.q.size());
    predict(model_, state.q, state.u, tau / 2, middle_);
    model_.linearise(when, middle_);
    const Input before = parts_.entered(state);
    mean_.assign(before.begin(), before.end());
    model_.kick(tau / 2, mean_);
    parts_.guess_impulse(state, tau, impulse_);
    parts_.projection().project(mean_, target, impulse_);
    parts_.require_finite_rates(state, mean_);
    next_.resize(state.q.size());
    model_.advance(state.q, mean_, tau, next_);
    for (std::size_t i = 0; i < mean_.size(); ++i) mean_[i] = 2 * mean_[i] - before[i];
    parts_.commit(state, when, next_, mean_);
    parts_.keep_multipliers(state, impulse_, tau);
  }

  Model& model_;
  StepParts<Model> parts_;
  std::vector<double> middle_, mean_, next_, impulse_;
  std::vector<double> fused_multipliers_;
};

/// Frank's projection scheme (Frank 1994, formulas 21 to 23): move freely, then project.
///
/// @f[ q^{n+1} = q^n + \tau S u^n, \qquad
///     u^{n+1} = \text{projection of } u^n + \tau W F(q^{n+1}) \text{ on } J(q^{n+1}) \, u = 0 @f]
///
/// First order. Momentum and angular momentum of a free body are exact. The energy is not: it falls at the rate (tau/2)
/// sum m |acceleration|^2, which makes the scheme robust and rules it out for waves that are to run.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 6.
template <ConstrainedModel Model>
class ProjectedStep {
 public:
  /// @param model  must outlive the stepper
  explicit ProjectedStep(Model& model) : model_(model), parts_(model, false) {}

  /// One step, tau > 0. Throws std::invalid_argument for tau, Divergence for infeasible configurations and rates that
  /// are not finite; the state is then as before the step.
  void step(State& state, double tau) {
    require_step(tau);
    parts_.guarded(state, [&] { take(state, tau); });
    ++state.steps;
  }

 private:
  void take(State& state, double tau) {
    const Interval when{state.time, tau};
    next_.resize(state.q.size());
    predict(model_, state.q, state.u, tau, next_);
    model_.linearise({when.end(), 0}, next_);
    rates_ = state.u;
    model_.kick(tau, rates_);
    impulse_.assign(constraint_count(model_), 0.0);
    parts_.projection().project(rates_, {}, impulse_);
    parts_.require_finite_rates(state, rates_);
    parts_.commit(state, when, next_, rates_);
  }

  Model& model_;
  StepParts<Model> parts_;
  std::vector<double> next_, rates_, impulse_;
};

}  // namespace seiche::mechanics
