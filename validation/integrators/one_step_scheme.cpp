/*
Frank (1994, chapter 1) integrates the equations of a constrained system,

$$M\dot u = J^T\lambda - \nabla\Pi, \qquad \dot q = u, \qquad f(q) = 0,$$

by one projection in the middle of the step:

$$\tilde q = q^n + \tfrac{\tau}{2} u^n, \quad u^* = u^n - \tfrac{\tau}{2} M^{-1}\nabla\Pi(\tilde q), \quad
\tilde u = u^* + \tfrac{\tau}{2} M^{-1} J^T\lambda, \quad J(\tilde q)\,\tilde u = 0,$$
$$q^{n+1} = q^n + \tau\tilde u, \qquad u^{n+1} = 2\tilde u - u^n .$$

He states that it takes half the work of second-order Runge-Kutta and is more accurate. Rigid chains are the smallest
test systems: a pendulum of `links` links (two: the spherical double pendulum), pinned, under gravity. Links have unit
length, masses are 1 and 1.3 in turn.

**What is compared.** The largest coordinate error at `time` against an adaptive method of order 8, for steps of $8\tau$
to $\tau/4$, as a function of the number of solves with $A = JM^{-1}J^T$ and of processor time. The scheme beside RK2,
RK4, RATTLE, the fully conservative implicit variant, fourth-order compositions, and two adaptive methods.

**What to look at.** The statement holds, by a factor of 13 at equal steps. For small errors over a short time, however,
high-order methods are far cheaper than either.
*/
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation::cases::one_step_scheme {

using mechanics::AdaptiveMethod;
using mechanics::Integrator;
using mechanics::State;
using rigid_chain::RigidChain;

// What an integrator costs and how exact it is on chains of rigid links.

/// A chain and the state it starts from.
struct ChainProblem {
  RigidChain chain;
  State start;
};

/// One entry per refinement.
struct WorkPrecision {
  std::vector<double> tau;
  std::vector<double> error;   ///< largest coordinate error at the end
  std::vector<double> solves;  ///< with A = J M^-1 J^T
  std::vector<double> cpu;     ///< s, shortest mean of five batches of runs that fill 3 ms
};

/// Largest difference of a coordinate.
double distance(const State& a, const State& b) {
  return over<Worst>(indices(a.q.size()), [&](std::size_t i) { return a.q[i] - b.q[i]; }).value();
}

/// run(chain, state) from the start, once to measure the error, then for the time.
template <class Run>
void measure(WorkPrecision& result, const ChainProblem& problem, const State& truth, const Run& run) {
  RigidChain chain = problem.chain;
  State state = problem.start;
  const long before = chain.solves();
  run(chain, state);
  result.error.push_back(distance(state, truth));
  result.solves.push_back(static_cast<double>(chain.solves() - before));
  Smallest shortest;
  for (int batch = 0; batch < 5; ++batch) {
    int runs = 0;
    const double begin = processor_seconds();
    do {
      state = problem.start;
      run(chain, state);
      ++runs;
    } while (processor_seconds() - begin < 0.003);
    shortest.add((processor_seconds() - begin) / runs);
  }
  result.cpu.push_back(shortest.value());
}

/// State at `time` by the adaptive Fehlberg method 7(8).
State adaptive_state(const ChainProblem& problem, double time, double tolerance) {
  RigidChain chain = problem.chain;
  State state = problem.start;
  mechanics::integrate_adaptive(mechanics::AdaptiveMethod::fehlberg_78, chain, state, time, tolerance);
  return state;
}

/// Error that the method would have for so many solves: a straight line between its points in logarithms.
double error_at(const WorkPrecision& curve, double solves) {
  std::size_t right = 1;
  while (right + 1 < curve.solves.size() && curve.solves[right] < solves) ++right;
  const double from = std::log(curve.solves[right - 1]);
  const double weight = (std::log(solves) - from) / (std::log(curve.solves[right]) - from);
  return std::exp((1 - weight) * std::log(curve.error[right - 1]) + weight * std::log(curve.error[right]));
}

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 1.2";

ChainProblem pendulum(const Values& values) {
  RigidChain chain({.masses = rigid_chain::alternating_masses(values.count("links")),
                    .pinned = true,
                    .gravity = values.real("gravity")});
  State start = spiral_start(chain);
  return {std::move(chain), std::move(start)};
}

Integrator judged(const Values& values) {
  return *std::find_if(mechanics::all_integrators.begin(), mechanics::all_integrators.end(),
                       [&](Integrator i) { return name(i) == values.text("scheme"); });
}

struct Curves {
  std::vector<long> steps;
  std::map<Integrator, WorkPrecision> fixed;
  std::vector<std::pair<std::string, WorkPrecision>> adaptive;  ///< tau stays empty
  double uncertainty = 0;                                       ///< of the state they are compared with
  WorkPrecision projection;  ///< Frank's projection scheme (21), with steps of the parameter tau
};
constexpr std::size_t middle = 3;  // the refinement whose step is the parameter tau

std::vector<long> refined_steps(const Values& values) {
  std::vector<long> steps;
  for (const double factor : {8.0, 4.0, 2.0, 1.0, 0.5, 0.25}) {
    steps.push_back(std::max(1L, std::lround(values.real("time") / (values.real("tau") * factor))));
  }
  return steps;
}

Curves compute(const Run& run) {
  const ChainProblem problem = pendulum(run);
  const double time = run.real("time");
  Curves curves;
  curves.steps = refined_steps(run);
  const State truth = adaptive_state(problem, time, 1e-14);
  // The error is proportional to the tolerance: a ninth of the difference, times a factor of safety of three.
  curves.uncertainty = distance(truth, adaptive_state(problem, time, 1e-13)) / 3;
  measure(curves.projection, problem, truth, [&](RigidChain& chain, State& state) {
    mechanics::ProjectedStep scheme(chain);
    const long steps = curves.steps[middle];
    for (long n = 0; n < steps; ++n) scheme.step(state, time / static_cast<double>(steps));
  });
  for (const Integrator integrator : mechanics::all_integrators) {
    WorkPrecision& own = curves.fixed[integrator];
    for (const long count : curves.steps) {
      const double tau = own.tau.emplace_back(time / static_cast<double>(count));
      measure(own, problem, truth, [&](RigidChain& chain, State& state) {
        const mechanics::StepFunction step = make_integrator(integrator, chain);
        for (long n = 0; n < count; ++n) step(state, tau);
      });
    }
  }
  for (const auto& [label, method] : {std::pair("Dormand-Prince 5", AdaptiveMethod::dormand_prince_5),
                                      std::pair("Fehlberg 7(8)", AdaptiveMethod::fehlberg_78)}) {
    WorkPrecision& own = curves.adaptive.emplace_back(label, WorkPrecision{}).second;
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      measure(own, problem, truth, [&, method = method](RigidChain& chain, State& state) {
        mechanics::integrate_adaptive(method, chain, state, time, tolerance);
      });
    }
  }
  return curves;
}

/// What Frank says of his scheme, and of no other.
void claim_half_the_cost(const Claims<Curves>& claims, const std::string& range) {
  // The largest ratio over the refinements k of the scheme.
  const auto largest_ratio = [](auto rk2_error) {
    return [rk2_error](const Curves& curves) {
      const WorkPrecision& own = curves.fixed.at(Integrator::one_step);
      const WorkPrecision& rk2 = curves.fixed.at(Integrator::runge_kutta_2);
      const auto ratio = [&](std::size_t k) { return own.error[k] / rk2_error(rk2, own.solves[k], k); };
      return over<Largest>(indices(own.error.size()), ratio).value();
    };
  };
  claims.at("equal steps")
      .check(
          "cost", "The number of solves per step is half the number for RK2.", "solves of the scheme / solves of RK2",
          [](const Curves& curves) {
            return curves.fixed.at(Integrator::one_step).solves[middle] /
                   curves.fixed.at(Integrator::runge_kutta_2).solves[middle];
          },
          Bound{.limit = 0, .reason = "one solve per step against two", .expected = 0.5});
  claims.at("equal steps")
      .from("Frank (1994), section 6.1")
      .check(
          "cost-of-projection", "The number of solves per step equals the projection scheme (21), which loses energy.",
          "solves of the scheme / solves of the projection scheme",
          [](const Curves& curves) {
            return curves.fixed.at(Integrator::one_step).solves[middle] / curves.projection.solves.front();
          },
          Bound{.limit = 0, .reason = "one solve per step in both", .expected = 1});
  claims.at(range).check("accuracy", "The error at equal steps is smaller than RK2's.",
                         "largest error ratio, scheme / RK2",
                         largest_ratio([](const WorkPrecision& rk2, double, std::size_t k) { return rk2.error[k]; }),
                         Bound{1, "better means a ratio below 1"});
  claims.at(range).check(
      "accuracy-at-equal-cost", "The error at equal numbers of solves is smaller than RK2's.",
      "largest error ratio, scheme / RK2",
      largest_ratio([](const WorkPrecision& rk2, double solves, std::size_t) { return error_at(rk2, solves); }),
      Bound{1, "better means a ratio below 1"});
}

void claims(const Values& values, const Claims<Curves>& claims) {
  const Integrator scheme = judged(values);
  const std::vector<long> steps = refined_steps(values);
  claim_half_the_cost(claims.only_if(scheme == Integrator::one_step, "stated by Frank of the one-step scheme only"),
                      fmt::format("{} .. {} steps", steps.front(), steps.back()));
  const bool fourth = order(scheme) == 4;
  claims.check(
      "order", fmt::format("The largest coordinate error converges at order {}.", order(scheme)),
      "order of the largest coordinate error",
      [scheme](const Curves& curves) {
        const WorkPrecision& own = curves.fixed.at(scheme);
        return evidence::observed_order(own.tau, own.error, 10 * curves.uncertainty);
      },
      Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.1,
            "smooth motion; errors below ten times the reference error are excluded"});
}

void show(const Curves& curves, const Values& values, evidence::Exhibit& exhibit) {
  const WorkPrecision& own = curves.fixed.at(judged(values));
  exhibit.measure("reference_uncertainty", curves.uncertainty);
  exhibit.measure("cpu_time_of_rk2_over_own", curves.fixed.at(Integrator::runge_kutta_2).cpu.back() / own.cpu.back());
  exhibit.measure("cpu_time_of_projection_over_own", curves.projection.cpu.front() / own.cpu[middle]);
  auto& figure = exhibit.figure("frank_integrator", "Half the cost of RK2, better accuracy",
                                "Largest coordinate error against the number of solves, and against processor time.",
                                {"frank-integrator"});
  auto& by_solves = figure.panel({.x = "solves", .y = "error", .log_x = true, .log_y = true});
  auto& by_time = figure.panel({.x = "processor time [s]", .y = "error", .log_x = true, .log_y = true});
  const auto draw = [&](const std::string& label, const WorkPrecision& curve, Role role) {
    by_solves.line(label, curve.solves, curve.error, role);
    by_time.line(label, curve.cpu, curve.error, role);
  };
  for (const auto& [integrator, curve] : curves.fixed) {
    draw(std::string(title(integrator)), curve, keeps_energy(integrator) ? Role::computed : Role::peer);
  }
  for (const auto& [label, curve] : curves.adaptive) draw(label + ", adaptive", curve, Role::peer);
}

void one_step_scheme(Case& c) {
  c.title = "The one-step scheme for constrained systems against Runge-Kutta";
  c.source = literature::frank + ", section 1.2";
  c.parameters = {
      integer("links", 2L, {1, 1000}, "links of the pendulum"),
      real("gravity", 1.0, "l/t^2", {0, 1e3}, "gravity on the pendulum"),
      choice("scheme", "one_step", {"one_step", "triple_jump", "suzuki", "conservative", "conservative_suzuki"},
             "the scheme evaluated; all are drawn"),
      real("time", 5.0, "t", {1e-3, 1e3}, "time at which the error is evaluated"),
      real("tau", 0.0125, "t", {1e-6, 10}, "middle of the range of steps, 8 tau to tau/4"),
  };
  c.published = {{.tiles = {"frank-integrator"}, .stated = {"scheme"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::one_step_scheme
