/// Adaptive Runge-Kutta methods of Boost.Odeint on the index-reduced form.
///
/// High order is the cheapest way to a small error over a short time; no invariant is kept.
///
/// References: Dormand & Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19;
/// Fehlberg, NASA TR R-287 (1968).
#pragma once

#include <functional>
#include <vector>

#include "seiche/mechanics/index_reduced.hpp"
#include "seiche/mechanics/step_parts.hpp"

namespace seiche::mechanics {

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

}  // namespace seiche::mechanics
