/// Frank's conservative one-step scheme for constrained systems, one solve per step (Frank 1994, formulas 4, 5).
///
///     q~ = q^n + (tau/2) S(q^n) u^n                                                        (4.1)
///     u* = u^n + (tau/2) W F(q~),   u~ = projection of u* on J(q~) u~ = 0                  (5)
///     q^{n+1} = q^n + tau S(q~) u~,   u^{n+1} = 2 u~ - u^n                                 (4.2)
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

#include <stdexcept>
#include <vector>

#include "seiche/mechanics/projection.hpp"
#include "seiche/mechanics/state.hpp"

namespace seiche::mechanics {

template <ConstrainedModel Model>
class OneStep {
 public:
  struct Settings {
    bool drift_feedback = false;    ///< J u~ = -f(q^n)/tau instead of 0: the constraints' drift no longer accumulates
    bool measure_residual = false;  ///< keep J u~ - target of each step, at the price of one more pass
  };

  /// @param model  must outlive the stepper
  /// Throws std::invalid_argument when drift_feedback is asked of a model without constraint_values.
  explicit OneStep(Model& model, Settings settings = {}) : model_(model), settings_(settings), projection_(model) {
    if (settings.drift_feedback && !HasConstraintValues<Model>) {
      throw std::invalid_argument("drift_feedback = true; allowed only for models with constraint_values");
    }
    if (settings.measure_residual && !HasMultipliers<Model>) {
      throw std::invalid_argument("measure_residual = true; allowed only for models with constraint_rates");
    }
  }

  /// One step, tau > 0. Throws std::invalid_argument for tau, Divergence for rates that are not finite; the state is
  /// then as before the step.
  void step(State& state, double tau) {
    require_step(tau);
    substep(state, tau);
    ++state.steps;
  }

  /// As step, for any sign of tau and without counting it: the stage of a composition.
  void substep(State& state, double tau) {
    const Interval when{state.time, tau};
    middle_.resize(state.q.size());
    predict(model_, state.q, state.u, tau / 2, middle_);
    model_.linearise(when, middle_);
    Input before = entered(state);
    mean_.assign(before.begin(), before.end());
    model_.kick(tau / 2, mean_);
    const Input target = drift_target(state.q, tau);
    impulse_.resize(constraint_count(model_));
    guess_impulse(state, tau);
    projection_.project(mean_, target, impulse_);
    if (const std::size_t bad = first_not_finite(mean_); bad < mean_.size()) {
      throw_not_finite(state, mean_, place_of_rate(model_, bad));
    }
    if constexpr (HasMultipliers<Model>) {
      if (settings_.measure_residual) {
        const Input residual = projection_.residual(mean_, target);
        residual_.assign(residual.begin(), residual.end());
      }
    }
    model_.advance(state.q, mean_, tau, state.q);
    for (std::size_t i = 0; i < mean_.size(); ++i) state.u[i] = 2 * mean_[i] - before[i];
    keep_multipliers(state, tau);
    if constexpr (requires { model_.settle(when, Output(state.q), Output(state.u)); }) {
      model_.settle(when, Output(state.q), Output(state.u));
    }
    state.time = when.end();
  }

  /// J u~ - target of the last step; empty unless measured.
  [[nodiscard]] Input residual() const { return residual_; }
  /// u~ of the last step, the velocity that satisfies the constraints.
  [[nodiscard]] Input mean_rates() const { return mean_; }
  [[nodiscard]] Model& model() { return model_; }

 private:
  Input entered(const State& state) {
    if constexpr (requires { model_.enter(Input(state.q), Output(entered_)); }) {
      entered_.assign(state.u.begin(), state.u.end());
      model_.enter(Input(state.q), Output(entered_));
      return entered_;
    } else {
      return state.u;
    }
  }

  Input drift_target([[maybe_unused]] Input q, [[maybe_unused]] double tau) {
    if constexpr (HasConstraintValues<Model>) {
      if (settings_.drift_feedback) {
        target_.resize(constraint_count(model_));
        model_.constraint_values(q, target_);
        for (double& t : target_) t /= -tau;
        return target_;
      }
    }
    return {};
  }

  /// The mean of two steps: single multipliers alternate.
  void guess_impulse([[maybe_unused]] const State& state, [[maybe_unused]] double tau) {
    if constexpr (requires { requires Model::warm_start; }) {
      const std::vector<double> guess = state.nodal_multipliers();
      for (std::size_t s = 0; s < impulse_.size(); ++s) {
        impulse_[s] = guess.size() == impulse_.size() ? 0.5 * tau * guess[s] : 0.0;
      }
    }
  }

  void keep_multipliers(State& state, double tau) {
    state.multipliers.swap(state.earlier_multipliers);
    state.multipliers.resize(impulse_.size());
    for (std::size_t s = 0; s < impulse_.size(); ++s) state.multipliers[s] = impulse_[s] * (2 / tau);
  }

  Model& model_;
  Settings settings_;
  Projection<Model> projection_;
  std::vector<double> middle_;
  std::vector<double> mean_;
  std::vector<double> entered_;
  std::vector<double> target_;
  std::vector<double> impulse_;
  std::vector<double> residual_;
};

}  // namespace seiche::mechanics
