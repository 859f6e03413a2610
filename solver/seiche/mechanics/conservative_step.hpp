/// Fully conservative implicit variant of the one-step scheme: energy, constraints and momenta all to round-off.
///
/// @f[ \tilde{u} = \text{projection of } u^n + \frac{\tau}{2} W F_d \text{ on } J_d \, \tilde{u} = 0 @f]
/// @f[ q^{n+1} = q^n + \tau S \tilde{u}, \qquad u^{n+1} = 2 \tilde{u} - u^n @f]
///
/// with discrete gradients over the segment q^n -> q^{n+1} (HasDiscreteGradients): for bilinear areas J_d is J at the
/// middle, for a cubic potential F_d is Simpson's mean of F. Fixed point on q^{n+1}, started from the velocity
/// extrapolated to the middle of the step; each sweep is one linearisation and one solve. It contracts like (omega
/// tau)^2/4 or tau |grad u|, and stops when the velocity no longer changes.
///
/// Second order, reversible. Conservation is the benefit, not accuracy: the phase error of waves is twice that of
/// OneStep and of opposite sign.
///
/// References: Frank (1994), chapter 1; McLachlan, Quispel & Robidoux, Geometric integration using discrete gradients,
/// Phil. Trans. R. Soc. A 357 (1999) 1021; Quispel & McLaren, A new class of energy-preserving numerical integration
/// methods, J. Phys. A 41 (2008) 045206.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/step_parts.hpp"

namespace seiche::mechanics {

/// Largest |after - before| and largest |after|.
SweepChange change_between(Input before, Input after);

template <ConstrainedModel Model>
requires HasDiscreteGradients<Model>
class ConservativeStep {
 public:
  struct Settings {
    bool drift_feedback = false;  ///< removes even the round-off drift of the constraints
    int most_sweeps = 60;
    int fixed_sweeps = 0;  ///< if positive: exactly so many, converged or not
  };

  explicit ConservativeStep(Model& model, Settings settings = {})
      : model_(model), settings_(settings), parts_(model, settings.drift_feedback) {}

  /// One step, tau > 0. Throws std::invalid_argument for tau; Divergence for rates that are not finite or sweeps that
  /// do not converge: the state is then as before the step.
  void step(State& state, double tau) {
    require_step(tau);
    substep(state, tau);
    ++state.steps;
  }

  /// As step, for any sign of tau and without counting it: the stage of a composition.
  void substep(State& state, double tau) {
    parts_.guarded(state, [&] { take(state, tau); });
  }

  /// Sweeps of the last step and of all steps.
  [[nodiscard]] int sweeps() const { return sweeps_; }
  [[nodiscard]] long total_sweeps() const { return total_sweeps_; }

 private:
  void take(State& state, double tau) {
    const Interval when{state.time, tau};
    extrapolate(state, tau);
    next_.resize(state.q.size());
    predict(model_, state.q, mean_, tau, next_);
    parts_.guess_impulse(state, tau, impulse_);
    iterate(state, when);
    const Input before = entered_.empty() ? Input(state.u) : Input(entered_);
    for (std::size_t i = 0; i < mean_.size(); ++i) mean_[i] = 2 * mean_[i] - before[i];
    parts_.commit(state, when, next_, mean_);
    parts_.keep_multipliers(state, impulse_, tau);
    state.earlier_u.swap(mean_);
    state.earlier_tau = tau;
  }

  /// u at the middle of the step from the state's last two; from u alone when it has but one.
  void extrapolate(const State& state, double tau) {
    mean_ = state.u;
    if (state.earlier_u.size() != mean_.size()) return;
    const double weight = tau / (2 * state.earlier_tau);
    for (std::size_t i = 0; i < mean_.size(); ++i) mean_[i] += weight * (state.u[i] - state.earlier_u[i]);
  }

  void iterate(const State& state, Interval when) {
    SweepChange change{std::numeric_limits<double>::infinity(), 0};
    const int most = settings_.fixed_sweeps > 0 ? settings_.fixed_sweeps : settings_.most_sweeps;
    const Input target = parts_.drift_target(state.q, when.length);
    for (sweeps_ = 0; sweeps_ < most;) {
      const double previous_change = change.largest_change;
      change = sweep(state, when, target);
      ++sweeps_;
      if (settings_.fixed_sweeps == 0 && converged(change, previous_change)) break;
    }
    total_sweeps_ += sweeps_;
    if (settings_.fixed_sweeps == 0 && sweeps_ == most && change.largest_change > noise(change)) {
      throw Divergence(fmt::format("implicit step not converged in {} sweeps: velocity changes by {:g} of its largest; "
                                   "take a shorter step",
                                   most, change.largest_change / change.largest_rate),
                       state.time, state.steps, 0);
    }
  }

  SweepChange sweep(const State& state, Interval when, Input target) {
    if constexpr (FusesSweep<Model>) {
      if (model_.fuses_step()) {
        impulse_.resize(constraint_count(model_));
        entered_.clear();
        return model_.fused_sweep(when, state.q, next_, state.u, mean_, target, impulse_, sweeps_);
      }
    }
    model_.linearise_between(when, state.q, next_, sweeps_);
    const Input before = parts_.entered(state);
    entered_.assign(before.begin(), before.end());
    candidate_ = entered_;
    model_.kick(when.length / 2, candidate_);
    if (sweeps_ == 0) kick_ = change_of_all(state, entered_, candidate_).largest_change;
    if constexpr (ProjectsItself<Model>) {
      parts_.projection().project(candidate_, target, impulse_);
    } else {
      model_.react(impulse_, candidate_);
      parts_.projection().correct(candidate_, target, impulse_);
    }
    const SweepChange change = change_of_all(state, mean_, candidate_);
    mean_.swap(candidate_);
    model_.advance(state.q, mean_, when.length, next_);
    return change;
  }

  /// change_between, of all processes where several step; throws for rates that are not finite.
  SweepChange change_of_all(const State& state, Input before, Input after) const {
    if constexpr (SharedOut<Model>) {
      return model_.of_all(change_between(before, after));
    } else {
      parts_.require_finite_rates(state, after);
      return change_between(before, after);
    }
  }

  /// The next change, by the contraction seen so far, is a unit in the last place, or below the accuracy of an
  /// iterative solver; or the change is small and no longer falling.
  [[nodiscard]] bool converged(SweepChange now, double previous_change) const {
    const double contraction =
        std::isfinite(previous_change) ? std::min(1.0, now.largest_change / previous_change) : 1.0;
    return now.largest_change * contraction <= accuracy() * now.largest_rate ||
           (now.largest_change >= previous_change && now.largest_change <= noise(now));
  }

  /// Above it a change that stops falling is divergence, not round-off. Where forces cancel, as in water at rest under
  /// pressure, what is left is the round-off of their kicks, a sum of some tens of terms.
  [[nodiscard]] double noise(SweepChange now) const {
    constexpr double of_forces = 100 * std::numeric_limits<double>::epsilon();
    return std::max(1e-11 * now.largest_rate, of_forces * kick_);
  }

  [[nodiscard]] double accuracy() const {
    constexpr double roundoff = std::numeric_limits<double>::epsilon();
    if constexpr (requires { model_.solver_accuracy(); }) {
      return std::max(roundoff, model_.solver_accuracy());
    } else {
      return roundoff;
    }
  }

  Model& model_;
  Settings settings_;
  StepParts<Model> parts_;
  int sweeps_ = 0;
  long total_sweeps_ = 0;
  double kick_ = 0;  // largest change of a rate by the forces alone
  std::vector<double> next_, mean_, candidate_, impulse_;
  std::vector<double> entered_;  // rates brought to the linearised configuration; empty after fused sweeps
};

}  // namespace seiche::mechanics
