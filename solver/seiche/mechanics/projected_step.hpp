/// Frank's projection scheme (Frank 1994, formulas 21 to 23): move freely, then project.
///
/// @f[ q^{n+1} = q^n + \tau S u^n, \qquad
///     u^{n+1} = \text{projection of } u^n + \tau W F(q^{n+1}) \text{ on } J(q^{n+1}) \, u = 0 @f]
///
/// First order. Momentum and angular momentum of a free body are exact. The energy is not: it falls at the rate (tau/2)
/// sum m |acceleration|^2, which makes the scheme robust and rules it out for waves that are to run.
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 6.
#pragma once

#include <vector>

#include "seiche/mechanics/step_parts.hpp"

namespace seiche::mechanics {

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
