/// Integrators to compare the one-step scheme with: midpoint and classical Runge-Kutta on the index-reduced form,
/// RATTLE.
///
/// RungeKutta2 and RungeKutta4 keep no invariant: constraints and energy drift. RATTLE is symplectic and keeps the
/// constraints and the momenta; energy is bounded and O(tau^2). Adaptive methods are those of Boost.Odeint.
///
/// When not to use them: for computing. They are here to be measured against.
///
/// References: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.1; Andersen,
/// Rattle: a velocity version of the Shake algorithm, J. Comput. Phys. 52 (1983) 24.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "seiche/divergence.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/mechanics/start.hpp"
#include "seiche/mechanics/step_parts.hpp"
#include "seiche/samples.hpp"

namespace seiche::mechanics {

/// Explicit Runge-Kutta method whose stage i starts from the slope of stage i-1 alone.
template <ConstrainedModel Model, std::size_t Stages>
requires HasMultipliers<Model>
class RungeKutta {
 public:
  explicit RungeKutta(Model& model) : form_(model) {}

  /// As OneStep::step.
  void step(State& state, double tau) {
    require_step(tau);
    StepParts<Model>::guarded(state, [&] { take(state, tau); });
  }

 private:
  void take(State& state, double tau) {
    end_q_ = stage_q_ = state.q;
    end_u_ = stage_u_ = state.u;
    slope_.resize(state.u.size());
    for (std::size_t i = 0; i < Stages; ++i) {
      form_.acceleration(state.time + nodes[i] * tau, stage_q_, stage_u_, slope_);
      form_.model().advance(end_q_, stage_u_, weights[i] * tau, end_q_);
      for (std::size_t k = 0; k < slope_.size(); ++k) end_u_[k] += weights[i] * tau * slope_[k];
      if (i + 1 == Stages) break;
      form_.model().advance(state.q, stage_u_, nodes[i + 1] * tau, stage_q_);
      for (std::size_t k = 0; k < slope_.size(); ++k) stage_u_[k] = state.u[k] + nodes[i + 1] * tau * slope_[k];
    }
    const std::size_t bad = first_not_finite(end_u_);
    if (bad < end_u_.size()) throw_not_finite(state, end_u_, place_of_rate(form_.model(), bad));
    state.q.swap(end_q_);
    state.u.swap(end_u_);
    state.time += tau;
    ++state.steps;
  }

  static_assert(Stages == 2 || Stages == 4);
  static constexpr auto nodes = [] {
    if constexpr (Stages == 2) {
      return std::array{0.0, 0.5};
    } else {
      return std::array{0.0, 0.5, 0.5, 1.0};
    }
  }();
  static constexpr auto weights = [] {
    if constexpr (Stages == 2) {
      return std::array{0.0, 1.0};
    } else {
      return std::array{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    }
  }();

  IndexReduced<Model> form_;
  std::vector<double> end_q_, end_u_, stage_q_, stage_u_, slope_;
};

template <class Model>
using RungeKutta2 = RungeKutta<Model, 2>;
template <class Model>
using RungeKutta4 = RungeKutta<Model, 4>;

/// Positions satisfy f(q^{n+1}) = 0 by simplified Newton iteration with A at q^n, velocities J u = 0 by projection.
template <ConstrainedModel Model>
requires(HasMultipliers<Model>&& HasConstraintValues<Model>) class Rattle {
 public:
  explicit Rattle(Model& model) : model_(model), projection_(model) {}

  /// As OneStep::step; throws Divergence also if the positions do not satisfy the constraints after 60 iterations.
  void step(State& state, double tau) {
    require_step(tau);
    StepParts<Model>::guarded(state, [&] { take(state, tau); });
  }

 private:
  void take(State& state, double tau) {
    model_.linearise({state.time, 0}, state.q);
    u_ = state.u;
    model_.kick(tau / 2, u_);
    satisfy_positions(state, tau);
    model_.linearise({state.time + tau, 0}, q_);
    model_.kick(tau / 2, u_);
    impulse_.assign(model_.constraints(), 0.0);
    projection_.project(u_, {}, impulse_);
    const std::size_t bad = first_not_finite(u_);
    if (bad < u_.size()) throw_not_finite(state, u_, place_of_rate(model_, bad));
    state.q.swap(q_);
    state.u.swap(u_);
    state.time += tau;
    ++state.steps;
  }

  void satisfy_positions(const State& state, double tau) {
    constexpr int most = 60;
    q_.resize(state.q.size());
    values_.resize(model_.constraints());
    impulse_.assign(model_.constraints(), 0.0);
    double previous = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most; ++k) {
      model_.advance(state.q, u_, tau, q_);
      model_.constraint_values(q_, values_);
      const double defect = std::abs(worst(values_));
      // Round-off: small and no longer falling.
      if (defect <= 4 * std::numeric_limits<double>::epsilon() || (defect < 1e-11 && defect >= previous)) return;
      previous = defect;
      for (double& f : values_) f /= -tau;
      model_.solve(values_, impulse_);
      model_.react(impulse_, u_);
    }
    throw Divergence("RATTLE: constraints not satisfied in " + std::to_string(most) + " iterations", state.time,
                     state.steps, 0);
  }

  Model& model_;
  Projection<Model> projection_;
  std::vector<double> q_, u_, values_, impulse_;
};

// Adaptive Runge-Kutta methods of Boost.Odeint on the index-reduced form.
//
// High order is the cheapest way to a small error over a short time; no invariant is kept.
//
// References: Dormand & Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19;
// Fehlberg, NASA TR R-287 (1968).

enum class AdaptiveMethod { dormand_prince_5, fehlberg_78 };

/// Integrates x' = slope(x, t) from begin to end; returns the evaluations of slope. Throws std::invalid_argument.
/// @param tolerance  absolute and relative, of one step
long integrate_adaptive(AdaptiveMethod method, const std::function<void(Input x, Output slope, double time)>& slope,
                        std::vector<double>& x, double begin, double end, double tolerance);

/// Carries the state to time `end`; returns the evaluations, one solve each. state.steps is not counted. Throws as
/// OneStep::step.
template <ConstrainedModel Model>
requires HasMultipliers<Model>
long integrate_adaptive(AdaptiveMethod method, Model& model, State& state, double end, double tolerance) {
  IndexReduced<Model> form(model);
  const std::size_t n = state.q.size();
  std::vector<double> x = state.q;
  x.insert(x.end(), state.u.begin(), state.u.end());
  const std::vector<double> origin(n, 0.0);
  const auto slope = [&](Input at, Output result, double time) {
    form.acceleration(time, at.first(n), at.subspan(n), result.subspan(n));
    model.advance(origin, at.subspan(n), 1, result.first(n));
  };
  long evaluations = 0;
  StepParts<Model>::guarded(state,
                            [&] { evaluations = integrate_adaptive(method, slope, x, state.time, end, tolerance); });
  state.q.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
  state.u.assign(x.begin() + static_cast<std::ptrdiff_t>(n), x.end());
  state.time = end;
  return evaluations;
}

// Every integrator of constant step by name, for comparisons: one call that hides what it is made of.
//
// When not to use it: in a model's own run, which names its integrator's type and keeps its settings.

enum class Integrator {
  one_step,
  triple_jump,
  suzuki,
  conservative,
  conservative_suzuki,
  runge_kutta_2,
  runge_kutta_4,
  rattle
};

inline constexpr auto all_integrators = [] {
  using enum Integrator;
  return std::array{one_step,      triple_jump,   suzuki, conservative, conservative_suzuki,
                    runge_kutta_2, runge_kutta_4, rattle};
}();

/// What is known of an integrator.
struct IntegratorFacts {
  std::string_view name;   ///< "one_step", ...
  std::string_view title;  ///< for figures: "its Suzuki composition", ...
  int order;
  bool keeps_energy;  ///< to round-off for a linear potential
};
const IntegratorFacts& facts_of(Integrator integrator);
inline std::string_view name(Integrator integrator) {
  return facts_of(integrator).name;
}
inline std::string_view title(Integrator integrator) {
  return facts_of(integrator).title;
}
inline int order(Integrator integrator) {
  return facts_of(integrator).order;
}
inline bool keeps_energy(Integrator integrator) {
  return facts_of(integrator).keeps_energy;
}

/// One step, with the errors of the integrator it stands for. @param model  must outlive the result
template <ConstrainedModel Model>
StepFunction make_integrator(Integrator integrator, Model& model) {
  using enum TimeComposition;
  const auto reference = [](auto stepper) -> StepFunction {
    return [stepper](State& state, double tau) { stepper->step(state, tau); };
  };
  switch (integrator) {
    case Integrator::triple_jump:
      return composed<OneStep<Model>>(model, {}, triple_jump);
    case Integrator::suzuki:
      return composed<OneStep<Model>>(model, {}, suzuki);
    case Integrator::conservative:
      return composed<ConservativeStep<Model>>(model, {}, none);
    case Integrator::conservative_suzuki:
      return composed<ConservativeStep<Model>>(model, {}, suzuki);
    case Integrator::runge_kutta_2:
      return reference(std::make_shared<RungeKutta2<Model>>(model));
    case Integrator::runge_kutta_4:
      return reference(std::make_shared<RungeKutta4<Model>>(model));
    case Integrator::rattle:
      return reference(std::make_shared<Rattle<Model>>(model));
    case Integrator::one_step:
      break;
  }
  return composed<OneStep<Model>>(model, {}, none);
}

}  // namespace seiche::mechanics
