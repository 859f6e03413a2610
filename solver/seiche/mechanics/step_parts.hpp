/// What every step of a constrained model shares: its settings, the entry into the linearised configuration, the
/// feedback of drifted constraints, and failure.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/flush_denormals.hpp"
#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/mechanics/state.hpp"

namespace seiche::mechanics {

/// The W-orthogonal projection of rates on {u : J u = target}, at the linearised configuration:
///
/// @f[ A \mu = \mathrm{target} - J u^*, \qquad \tilde{u} = u^* + W J^T \mu, \qquad A = J W J^T \tag{Frank 1994, 5} @f]
///
/// mu is the impulse of the multipliers: lambda = 2 mu/tau in a step of length tau.
template <ConstrainedModel Model>
class Projection {
 public:
  explicit Projection(Model& model) : model_(model) {}

  /// @param u       on entry u*, on exit u~
  /// @param target  empty for zero
  /// @param mu      constraint_count(model) impulses; on entry a guess, which only iterative solvers use
  void project(Output u, Input target, Output mu) {
    if constexpr (ProjectsItself<Model>) {
      model_.project(u, target, mu);
    } else {
      defect(u, target);
      model_.solve(right_hand_side_, mu);
      model_.react(mu, u);
    }
  }

  /// One correction of u and mu towards the target with whatever factorisation the model holds: with that of another
  /// configuration the defect shrinks by a factor, with its own it vanishes. On entry u already holds the reaction to
  /// mu.
  void correct(Output u, Input target, Output mu) {
    defect(u, target);
    correction_.assign(mu.size(), 0.0);
    model_.solve(right_hand_side_, correction_);
    for (std::size_t s = 0; s < mu.size(); ++s) mu[s] += correction_[s];
    model_.react(correction_, u);
  }

 private:
  void defect(Input u, Input target) {
    right_hand_side_.resize(model_.constraints());
    model_.constraint_rates(u, right_hand_side_);
    if (target.empty()) {
      for (double& r : right_hand_side_) r = -r;
    } else {
      for (std::size_t s = 0; s < target.size(); ++s) right_hand_side_[s] = target[s] - right_hand_side_[s];
    }
  }

  Model& model_;
  std::vector<double> right_hand_side_;
  std::vector<double> correction_;
};

template <ConstrainedModel Model>
class StepParts {
 public:
  /// @param drift_share  of the drift that a step takes back
  /// Throws std::invalid_argument when drift_feedback is asked of a model without constraint_values.
  StepParts(Model& model, bool drift_feedback, double drift_share = 1)
      : model_(model), drift_feedback_(drift_feedback), drift_share_(drift_share), projection_(model) {
    if (drift_feedback && !HasConstraintValues<Model>) {
      throw std::invalid_argument("drift_feedback = true; allowed only for models with constraint_values");
    }
  }

  /// The state's rates brought to the linearised configuration; valid until the next call.
  Input entered(const State& state) {
    if constexpr (requires { model_.enter(Input(state.q), Output(entered_)); }) {
      entered_.assign(state.u.begin(), state.u.end());
      model_.enter(Input(state.q), Output(entered_));
      return entered_;
    } else {
      return state.u;
    }
  }

  /// -f(q)/tau with drift feedback, or the share of it; empty without.
  Input drift_target([[maybe_unused]] Input q, [[maybe_unused]] double tau) {
    if constexpr (HasConstraintValues<Model>) {
      if (drift_feedback_) {
        target_.resize(constraint_count(model_));
        model_.constraint_values(q, target_);
        for (double& t : target_) t = -drift_share_ * t / tau;
        return target_;
      }
    }
    return {};
  }

  /// The end of the step: walls, tips, frames.
  void settle(Interval when, Output q, Output u) {
    if constexpr (requires { model_.settle(when, q, u); }) model_.settle(when, q, u);
  }

  /// The end of the step in q and u, which only then become the state's; they get what the state had.
  void commit(State& state, Interval when, std::vector<double>& q, std::vector<double>& u) {
    settle(when, q, u);
    state.q.swap(q);
    state.u.swap(u);
    state.earlier_u.clear();
    state.time = when.end();
  }

  /// Impulses for an iterative solver to start from: the parabola through the last three steps' multipliers, for equal
  /// steps. Of two the mean, since single ones may alternate. Zero for other models.
  void guess_impulse([[maybe_unused]] const State& state, [[maybe_unused]] double tau, std::vector<double>& impulse) {
    impulse.assign(constraint_count(model_), 0.0);
    if constexpr (requires { requires Model::warm_start; }) {
      const std::vector<double>& last = state.multipliers;
      const std::vector<double>& before = state.earlier_multipliers;
      const std::vector<double>& first = state.earliest_multipliers;
      if (last.size() != impulse.size() || before.size() != impulse.size()) return;
      if (first.size() != impulse.size()) {
        for (std::size_t s = 0; s < impulse.size(); ++s) impulse[s] = 0.25 * tau * (last[s] + before[s]);
        return;
      }
      for (std::size_t s = 0; s < impulse.size(); ++s) {
        impulse[s] = 0.5 * tau * (3 * (last[s] - before[s]) + first[s]);
      }
    }
  }

  /// Multipliers of a step of length tau from their impulses.
  static void keep_multipliers(State& state, Input impulse, double tau) {
    std::vector<double>& multipliers = state.next_multipliers();
    multipliers.resize(impulse.size());
    for (std::size_t s = 0; s < impulse.size(); ++s) multipliers[s] = impulse[s] * (2 / tau);
  }

  void require_finite_rates(const State& state, Input rates) const {
    if (const std::size_t bad = first_not_finite(rates); bad < rates.size()) {
      throw_not_finite(state, rates, place_of_rate(model_, bad));
    }
  }

  /// Runs `work` without denormal numbers; what the model finds infeasible becomes Divergence with the state's time and
  /// step.
  template <class Work>
  static void guarded(const State& state, Work&& work) {
    const FlushDenormals guard;
    try {
      std::forward<Work>(work)();
    } catch (const Infeasible& failure) {
      throw Divergence(failure.what(), state.time, state.steps, failure.place());
    } catch (const linear::NotPositiveDefinite& failure) {
      throw Divergence(failure.what(), state.time, state.steps, static_cast<double>(failure.row()));
    } catch (const linear::NotConverged& failure) {
      throw Divergence(failure.what(), state.time, state.steps, 0);
    } catch (const linear::NotPositiveDirection& failure) {
      throw Divergence(failure.what(), state.time, state.steps, 0);
    }
  }

  [[nodiscard]] Projection<Model>& projection() { return projection_; }

 private:
  Model& model_;
  bool drift_feedback_;
  double drift_share_;
  Projection<Model> projection_;
  std::vector<double> entered_;
  std::vector<double> target_;
};

}  // namespace seiche::mechanics
