/// What a constrained mechanical system offers to the integrators of this folder.
///
/// Configuration q (whatever is moved: coordinates of nodes, markers that merely ride along), rates u (generalised
/// velocities with inverse mass W), potential Pi, and constraints whose rates J(q) u vanish:
///
/// @f[ \dot{u} = W (F + J^T \lambda), \qquad F = -\nabla \Pi + \text{external forces}, \qquad J u = 0, \qquad
///     \dot{q} = S(q) \, u \tag{Frank 1994, 3} @f]
///
/// J need not be the derivative of a function of q, nor q and u be of one length: S maps rates to the motion of q (a
/// rotation into the bottom's tangent, a contact point sliding on a wall). W may hold walls (singular blocks).
///
/// All arrays are flat and belong to the integrator. A model keeps what depends on the configuration (gradients,
/// factorised A = J W J^T) from one call of linearise to the next; nothing else of it changes in a step.
///
/// Required of every model, all at the configuration of the last linearise:
///
///     coordinates(), rates()     lengths of q and u
///     linearise(Interval, q)     gradients, S, A and its factorisation at q; throws Infeasible
///     kick(h, u)                 u += h W F
///     advance(from, u, h, to)    to = from + h S u; from and to may be one array
///
/// and one of the two ways to the W-orthogonal projection on J u = target (an empty target means zero):
///
///     constraints()              length of lambda; may change with linearise (free-Lagrangian models)
///     constraint_rates(u, w)     w = J u, with the rates of prescribed nodes
///     react(mu, u)               u += W J^T mu
///     solve(rhs, mu)             A mu = rhs; mu holds a guess if `static constexpr bool warm_start = true`
///
///     project(u, target, mu)     the projection in one call: passes fused, or on a basis without multipliers (then
///                                constraints() is 0 or absent); mu receives the impulses of the multipliers
///
/// Optional, found by the compiler:
///
///     predict(from, u, h, to)    as advance, with S at `from` itself; absent: S does not depend on q
///     enter(q, u)                brings u from q to the linearised configuration: transport of frames, walls
///     settle(Interval, q, u)     at the end of the step: transport back, walls' own velocities, tips on the bed
///     linearise_between(Interval, q0, q1, sweep)   discrete gradients over the segment (conservative_step.hpp)
///     constraint_values(q, f)    defects of the constraints themselves (drift feedback, RATTLE, invariants)
///     curvature(u, v, b)         b_s = u^T (Hessian of f_s) v; absent: by differences of J (start.hpp)
///     solver_accuracy()          relative accuracy of solve where it is iterative (conservative_step.hpp), else 0
///     place(i)                   coordinate of rate i, for messages
///     of_all(SweepChange)        the change of a sweep of all processes that share the model out (SharedOut)
///     fused_sweep(Interval, q0, q1, u0, mean, target, mu, sweep)   likewise (FusesSweep)
///     fused_step(Interval, q, u, target, lambda)   the whole step in few passes, for speed alone (FusesStep)
///
/// Reference: A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 1.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

#include "seiche/divergence.hpp"

namespace seiche::mechanics {

using seiche::Infeasible;

using Input = std::span<const double>;
using Output = std::span<double>;

/// The time a step spans; length 0 for an instant, negative inside compositions.
struct Interval {
  double begin = 0;
  double length = 0;
  [[nodiscard]] double middle() const { return begin + length / 2; }
  [[nodiscard]] double end() const { return begin + length; }
};

template <class Model>
concept HasMultipliers = requires(Model& model, const Model& fixed, Input in, Output out) {
  { fixed.constraints() } -> std::convertible_to<std::size_t>;
  fixed.constraint_rates(in, out);
  fixed.react(in, out);
  model.solve(in, out);
};

template <class Model>
concept ProjectsItself = requires(Model& model, Input in, Output out) {
  model.project(out, in, out);
};

template <class Model>
concept ConstrainedModel = requires(Model& model, const Model& fixed, Interval when, Input in, Output out, double h) {
  { fixed.coordinates() } -> std::convertible_to<std::size_t>;
  { fixed.rates() } -> std::convertible_to<std::size_t>;
  model.linearise(when, in);
  fixed.kick(h, out);
  fixed.advance(in, in, h, out);
}
&&(HasMultipliers<Model> || ProjectsItself<Model>);

/// Discrete gradients over the segment q0 -> q1: J (q1 - q0) = f(q1) - f(q0) and F.(q1 - q0) = Pi(q0) - Pi(q1),
/// exactly. `sweep` counts the iterations of the step from 0: a model may factorise A in sweep 0 only, or hold its
/// directions from some sweep on.
template <class Model>
concept HasDiscreteGradients = requires(Model& model, Interval when, Input q0, Input q1, int sweep) {
  model.linearise_between(when, q0, q1, sweep);
};

/// The whole of OneStep's step in a few passes over memory, for models whose solver goes through the unknowns in order.
/// q, u: the state's, replaced; target: may be empty; multipliers: receives lambda. It must do what the separate calls
/// do, and leave q and u as they were when it throws; settle then throws nothing. fuses_step() may depend on the
/// settings of the model.
template <class Model>
concept FusesStep = requires(Model& model, const Model& fixed, Interval when, Input in, Output out) {
  { fixed.fuses_step() } -> std::convertible_to<bool>;
  model.fused_step(when, out, out, in, out);
};

/// Largest change of a rate in a sweep of ConservativeStep, and the largest rate after it.
struct SweepChange {
  double largest_change = 0;
  double largest_rate = 0;
};

/// The same for a sweep of ConservativeStep: from the guesses q1 and mean (rates at the middle of the step) to better
/// ones; u0: rates at the beginning; mu: receives the impulses.
template <class Model>
concept FusesSweep = FusesStep<Model> && requires(Model& model, Interval when, Input in, Output out, int sweep) {
  { model.fused_sweep(when, in, out, in, out, in, out, sweep) } -> std::same_as<SweepChange>;
};

/// A model of which each process steps a part: sweeps end together, by the change of all of them. of_all throws
/// Infeasible everywhere for a change that is not finite anywhere.
template <class Model>
concept SharedOut = requires(const Model& fixed, SweepChange change) {
  { fixed.of_all(change) } -> std::same_as<SweepChange>;
};

template <class Model>
concept HasConstraintValues = requires(const Model& model, Input q, Output f) {
  model.constraint_values(q, f);
};

template <class Model>
concept HasCurvature = requires(const Model& model, Input u, Output b) {
  model.curvature(u, u, b);
};

template <class Model>
std::size_t constraint_count(const Model& model) {
  if constexpr (requires { model.constraints(); }) {
    return model.constraints();
  } else {
    return 0;
  }
}

/// to = from + h S(from) u.
template <ConstrainedModel Model>
void predict(const Model& model, Input from, Input u, double h, Output to) {
  if constexpr (requires { model.predict(from, u, h, to); }) {
    model.predict(from, u, h, to);
  } else {
    model.advance(from, u, h, to);
  }
}

template <class Model>
double place_of_rate(const Model& model, std::size_t i) {
  if constexpr (requires { model.place(i); }) {
    return model.place(i);
  } else {
    return static_cast<double>(i);
  }
}

}  // namespace seiche::mechanics
