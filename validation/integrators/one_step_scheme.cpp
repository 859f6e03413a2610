/*
Frank (1994, chapter 1) integrates the equations of a constrained system,

$$M\dot u = J^T\lambda - \nabla\Pi, \qquad \dot q = u, \qquad f(q) = 0,$$

by one projection in the middle of the step:

$$\tilde q = q^n + \tfrac{\tau}{2} u^n, \quad u^* = u^n - \tfrac{\tau}{2} M^{-1}\nabla\Pi(\tilde q), \quad
\tilde u = u^* + \tfrac{\tau}{2} M^{-1} J^T\lambda, \quad J(\tilde q)\,\tilde u = 0,$$
$$q^{n+1} = q^n + \tau\tilde u, \qquad u^{n+1} = 2\tilde u - u^n .$$

He states that it takes half the work of second-order Runge-Kutta and is more accurate. Rigid chains are the smallest
systems on which this can be seen: a pendulum of `links` links (two: the spherical double pendulum), pinned, under
gravity; and a free chain of `free_links`. Links have unit length, masses are 1 and 1.3 in turn.

**What is compared.** Accuracy: the largest error of a coordinate at the time `time` against an adaptive method of order
8, for steps of $8\tau$ to $\tau/4$, as a function of the solves with $A = JM^{-1}J^T$ and of processor time. What is
kept: energy, momentum, angular momentum and link lengths over `long_steps` steps. The scheme beside RK2, RK4, RATTLE,
the fully conservative implicit variant, compositions to fourth order, and two adaptive methods.

**What to look at.** The statement holds, by a factor of 13 at equal steps. What it leaves out: for a small error over a
short time, methods of high order are far cheaper than either. Runge-Kutta methods keep the momentum, like any linear
invariant, and lose energy, angular momentum and links; RATTLE keeps the links and the momenta exactly and the energy
within a bound; the compositions are of high order and keep energy and momenta exactly, links within a small bound.
The free chain in runs of more than 1e5 steps: rounding makes the multipliers alternate more and more, and the energy
then drifts by their work on the rounding of the rates; reprojecting the velocity now and then is the cure.
*/
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "seiche/mechanics/projected_step.hpp"
#include "validation/case/case.hpp"
#include "validation/integrators/integrator_runs.hpp"

namespace seiche::validation::cases::one_step_scheme {
namespace {

using mechanics::AdaptiveMethod;
using mechanics::Integrator;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 1.2";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Role role_of(Integrator integrator) {
  const bool ours = keeps_energy(integrator);
  return ours ? Role::computed : Role::peer;
}

ChainProblem pendulum(const Values& values) {
  rigid_chain::RigidChain chain(
      {.masses = rigid_chain::alternating_masses(static_cast<std::size_t>(values.integer("links"))),
       .pinned = true,
       .gravity = values.real("gravity")});
  mechanics::State start = spiral_start(chain);
  return {std::move(chain), std::move(start)};
}

ChainProblem free_chain(const Values& values) {
  rigid_chain::RigidChain chain(
      {.masses = rigid_chain::alternating_masses(static_cast<std::size_t>(values.integer("free_links")) + 1)});
  mechanics::State start = spiral_start(chain);
  return {std::move(chain), std::move(start)};
}

Integrator judged(const Values& values) {
  return *std::find_if(mechanics::all_integrators.begin(), mechanics::all_integrators.end(),
                       [&](Integrator i) { return name(i) == values.text("scheme"); });
}

struct Curves {
  std::vector<long> steps;
  std::vector<std::pair<Integrator, WorkPrecision>> fixed;
  std::vector<std::pair<std::string, WorkPrecision>> adaptive;
  double uncertainty = 0;  ///< of the state they are compared with
  double projection = 0;   ///< solves in a step of Frank's projection scheme (21)

  [[nodiscard]] const WorkPrecision& of(Integrator integrator) const {
    return std::find_if(fixed.begin(), fixed.end(), [&](const auto& entry) { return entry.first == integrator; })
        ->second;
  }
};
constexpr std::size_t middle = 3;  // the refinement whose step is the parameter tau

std::vector<long> refined_steps(const Values& values) {
  std::vector<long> steps;
  for (const double factor : {8.0, 4.0, 2.0, 1.0, 0.5, 0.25}) {
    steps.push_back(std::max(1L, std::lround(values.real("time") / (values.real("tau") * factor))));
  }
  return steps;
}

Curves measure_curves(const Run& run, const ChainProblem& problem) {
  const double time = run.real("time");
  Curves curves;
  curves.steps = refined_steps(run);
  const mechanics::State truth = adaptive_state(problem, time, 1e-14);
  // The error is proportional to the tolerance: a ninth of the difference, times a factor of safety of three.
  curves.uncertainty = distance(truth, adaptive_state(problem, time, 1e-13)) / 3;
  rigid_chain::RigidChain chain = problem.chain;
  mechanics::State state = problem.start;
  const long before = chain.solves();
  mechanics::ProjectedStep(chain).step(state, run.real("tau"));
  curves.projection = static_cast<double>(chain.solves() - before);
  for (const Integrator integrator : mechanics::all_integrators) {
    curves.fixed.emplace_back(integrator, work_and_precision(problem, integrator, curves.steps, time, truth));
  }
  const std::vector<double> tolerances = {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};
  curves.adaptive.emplace_back("Dormand-Prince 5",
                               work_and_precision(problem, AdaptiveMethod::dormand_prince_5, tolerances, time, truth));
  curves.adaptive.emplace_back("Fehlberg 7(8)",
                               work_and_precision(problem, AdaptiveMethod::fehlberg_78, tolerances, time, truth));
  return curves;
}

struct History {
  Integrator integrator;
  KeptInvariants kept;
};

std::vector<History> follow_all(const Run& run, const ChainProblem& problem, bool pinned, double done) {
  std::vector<History> histories;
  for (const Integrator integrator : mechanics::all_integrators) {
    const double from = done + 0.45 * static_cast<double>(histories.size()) / mechanics::all_integrators.size();
    histories.push_back(
        {integrator,
         kept_invariants(problem, integrator, run.real("long_tau"), run.integer("long_steps"), pinned,
                         [&](double part) { run.progress(from + 0.45 * part / mechanics::all_integrators.size()); })});
  }
  return histories;
}

struct Results {
  Curves curves;
  std::vector<History> pendulum, free_chain;

  [[nodiscard]] const std::vector<History>& of(bool pinned) const { return pinned ? pendulum : free_chain; }
};

/// What an integrator keeps of one of the systems.
Claims<KeptInvariants> of(const Claims<Results>& claims, Integrator integrator, bool pinned) {
  return claims.of([integrator, pinned](const Results& r) -> const KeptInvariants& {
    return std::ranges::find(r.of(pinned), integrator, &History::integrator)->kept;
  });
}

/// What Frank says of his scheme, and of no other.
void claim_half_the_cost(const Claims<Curves>& claims, const std::string& range) {
  const auto largest_ratio = [](const Curves& curves, auto rk2_error) {
    const WorkPrecision& own = curves.of(Integrator::one_step);
    Largest ratio;
    for (std::size_t i = 0; i < own.error.size(); ++i) {
      ratio.add(own.error[i] / rk2_error(curves.of(Integrator::runge_kutta_2), own, i));
    }
    return ratio.value();
  };
  claims.at("equal steps")
      .check(
          "cost", "A step costs half of RK2's.", "solves of the scheme / solves of RK2",
          [](const Curves& curves) {
            return curves.of(Integrator::one_step).solves[middle] / curves.of(Integrator::runge_kutta_2).solves[middle];
          },
          Bound{.limit = 0, .reason = "one solve per step against two", .expected = 0.5});
  claims.at("equal steps")
      .from("Frank (1994), section 6.1")
      .check(
          "cost-of-projection", "A step costs what one of the projection scheme (21) costs, which loses energy.",
          "solves of the scheme / solves of the projection scheme",
          [](const Curves& curves) {
            return curves.of(Integrator::one_step).solves[middle] / static_cast<double>(curves.steps[middle]) /
                   curves.projection;
          },
          Bound{.limit = 0, .reason = "one solve per step in both", .expected = 1});
  claims.at(range).check(
      "accuracy", "The error at equal steps is smaller than RK2's.", "largest error ratio, scheme / RK2",
      [largest_ratio](const Curves& curves) {
        return largest_ratio(
            curves, [](const WorkPrecision& rk2, const WorkPrecision&, std::size_t i) { return rk2.error[i]; });
      },
      Bound{1, "better means less than 1"});
  claims.at(range).check(
      "accuracy-at-equal-cost", "The error at equal numbers of solves is smaller than RK2's.",
      "largest error ratio, scheme / RK2",
      [largest_ratio](const Curves& curves) {
        return largest_ratio(curves, [](const WorkPrecision& rk2, const WorkPrecision& own, std::size_t i) {
          return error_at(rk2, own.solves[i]);
        });
      },
      Bound{1, "better means less than 1"});
}

void claim_accuracy(const Claims<Curves>& claims, const Values& values) {
  const Integrator scheme = judged(values);
  const std::vector<long> steps = refined_steps(values);
  claim_half_the_cost(claims.only_if(scheme == Integrator::one_step, "Frank says it of the one-step scheme only"),
                      fmt::format("{} .. {} steps", steps.front(), steps.back()));
  const bool fourth = order(scheme) == 4;
  claims.check(
      "order", fmt::format("The scheme is of order {}.", order(scheme)), "order of the largest coordinate error",
      [scheme](const Curves& curves) {
        const WorkPrecision& own = curves.of(scheme);
        return evidence::observed_order(own.tau, own.error, 10 * curves.uncertainty);
      },
      Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.1,
            "smooth motion; errors below ten times that of the reference are left out"});
}

/// The largest that scales can become: energy is conserved, so that it is ten times what the start has and gravity can
/// add, at most; the other scales follow from it.
rigid_chain::Scales largest_scales(const Values& values, bool pinned) {
  ChainProblem problem = pinned ? pendulum(values) : free_chain(values);
  const auto links = static_cast<double>(problem.chain.constraints());
  const std::vector<double>& masses = problem.chain.masses();
  const double mass = std::accumulate(masses.begin(), masses.end(), 0.0);
  const double gravity = pinned ? values.real("gravity") : 0;
  rigid_chain::Scales most = scales_of(problem.chain, problem.start);
  most.energy = 10 * (most.energy + mass * gravity * links);
  most.momentum = std::sqrt(2 * mass * most.energy);
  const double time = values.real("long_tau") * static_cast<double>(values.integer("long_steps"));
  most.angular_momentum = most.momentum * (links + (pinned ? 0 : time * most.momentum / mass));
  return most;
}

void claim_conservation(const Claims<Results>& all, const Values& values, bool pinned) {
  const Integrator scheme = judged(values);
  const Claims<KeptInvariants> claims = of(all, scheme, pinned);
  const double tau = values.real("long_tau");
  const auto steps = static_cast<double>(values.integer("long_steps"));
  // Where the multipliers of a free chain begin to alternate, rounding costs more: see the article.
  const double until = pinned ? steps : std::min(steps, 1e5);
  const rigid_chain::Scales most = largest_scales(values, pinned);
  const auto claim = [&](const std::string& id, const std::string& text, std::vector<double> KeptInvariants::*defect,
                         double rigid_chain::Scales::*scale, const std::string& reason) {
    claims.at(fmt::format("tau = {:g}, {:g} steps", tau, until))
        .check((pinned ? "pendulum-" : "free-chain-") + id, text, "largest defect",
               [=](const KeptInvariants& kept) -> Measurement {
                 const std::optional<std::size_t> last = kept.last_until(until * tau);
                 return {.value = last ? (kept.*defect)[*last] : nan,
                         .told = {.scale = last ? kept.scales[*last].*scale : nan}};
               },
               Roundoff{.operations = until * static_cast<double>(stages(scheme)),
                        .scale = Amount::told_by_run(most.*scale),
                        .reason = reason + ", once per solved stage"});
  };
  claim("energy", pinned ? "Energy of the pendulum is kept: its potential is linear." : "Energy of the chain is kept.",
        &KeptInvariants::energy, &rigid_chain::Scales::energy, "rounding of T + |Pi|");
  if (!pinned) {
    claim("momentum", "Momentum of the free chain is conserved to round-off.", &KeptInvariants::momentum,
          &rigid_chain::Scales::momentum, "rounding of sum m|u|");
  }
  claim("angular-momentum",
        pinned ? "Angular momentum about the vertical through the pin is kept."
               : "Angular momentum of the free chain is conserved to round-off.",
        &KeptInvariants::angular_momentum, &rigid_chain::Scales::angular_momentum,
        "rounding of sum m|r||u|, which grows as a free chain leaves");
  claims.at(fmt::format("tau = {:g}, {:g} steps", tau, steps))
      .only_if(scheme == Integrator::one_step, "it is a law of the one-step scheme")
      .check(
          pinned ? "pendulum-links" : "free-chain-links",
          "Links change only by (tau^2/8) times the square of the velocity across them.", "largest defect",
          [pinned](const KeptInvariants& kept) -> Measurement {
            if (!kept.broken_down.empty()) return {.told = {.scale = nan}};
            const rigid_chain::Scales& whole = kept.scales.back();
            return {.value = kept.modified_links,
                    .told = {.scale = pinned ? 1 : whole.angular_momentum / whole.momentum}};
          },
          Roundoff{
              .operations = steps * static_cast<double>(stages(scheme)),
              .scale = Amount::told_by_run(pinned ? 1 : most.angular_momentum / most.momentum),
              .reason = "a rounded coordinate, of the size of the distance from the origin, once per solved stage"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_accuracy(claims.of(&Results::curves), values);
  for (const bool pinned : {true, false}) claim_conservation(claims, values, pinned);
}

Results compute(const Run& run) {
  const ChainProblem pinned = pendulum(run);
  Results r{.curves = measure_curves(run, pinned)};
  run.progress(0.1);
  r.pendulum = follow_all(run, pinned, true, 0.1);
  r.free_chain = follow_all(run, free_chain(run), false, 0.55);
  return r;
}

void draw_curves(evidence::Exhibit& exhibit, const Curves& curves) {
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
    draw(std::string(title(integrator)), curve, role_of(integrator));
  }
  for (const auto& [label, curve] : curves.adaptive) draw(label + ", adaptive", curve, Role::peer);
}

void draw_histories(evidence::Exhibit& exhibit, const std::vector<History>& histories, bool pinned) {
  auto& figure = exhibit.figure(pinned ? "pendulum" : "free_chain",
                                pinned ? "What the pendulum keeps" : "What the free chain keeps",
                                "Largest defects so far; what is exactly zero is not drawn.");
  const auto draw = [&](const std::string& label, std::vector<double> KeptInvariants::*quantity) {
    auto& panel = figure.panel({.x = "time", .y = label, .log_x = true, .log_y = true});
    for (const History& history : histories) {
      std::vector<double> time;
      std::vector<double> defect;
      for (std::size_t i = 0; i < history.kept.time.size(); ++i) {
        if ((history.kept.*quantity)[i] <= 0) continue;
        time.push_back(history.kept.time[i]);
        defect.push_back((history.kept.*quantity)[i]);
      }
      panel.line(std::string(title(history.integrator)), time, defect, role_of(history.integrator));
    }
  };
  draw("energy defect", &KeptInvariants::energy);
  if (!pinned) draw("momentum defect", &KeptInvariants::momentum);
  draw(pinned ? "vertical angular momentum" : "angular momentum defect", &KeptInvariants::angular_momentum);
  draw("link defect", &KeptInvariants::links);
}

void tabulate(evidence::Exhibit& exhibit, const std::vector<History>& histories, bool pinned) {
  evidence::Table table{.id = pinned ? "pendulum" : "free_chain",
                        .title = pinned ? "Pendulum: largest defects" : "Free chain: largest defects",
                        .caption = "Over the whole run; a run that breaks down is given up to there.",
                        .columns = table_columns({"integrator", "until", "energy [1]", "momentum [1]",
                                                  "angular momentum [1]", "links [1]"})};
  for (const History& history : histories) {
    const KeptInvariants& kept = history.kept;
    if (kept.time.empty()) continue;
    std::vector<std::variant<double, std::string>> row = {std::string(title(history.integrator)), kept.time.back(),
                                                          kept.energy.back()};
    row.emplace_back(pinned ? std::variant<double, std::string>("not kept: pin") : kept.momentum.back());
    row.insert(row.end(), {kept.angular_momentum.back(), kept.links.back()});
    table.rows.push_back(std::move(row));
  }
  exhibit.table(std::move(table));
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("reference_uncertainty", r.curves.uncertainty);
  exhibit.measure("cpu_time_of_rk2_over_own",
                  r.curves.of(Integrator::runge_kutta_2).cpu.back() / r.curves.of(judged(values)).cpu.back());
  draw_curves(exhibit, r.curves);
  for (const bool pinned : {true, false}) {
    draw_histories(exhibit, r.of(pinned), pinned);
    tabulate(exhibit, r.of(pinned), pinned);
  }
}

}  // namespace

Case one_step_scheme() {
  Case c;
  c.title = "The one-step scheme for constrained systems against Runge-Kutta";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 1.2";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("links", 2L, {1, 1000}, "links of the pendulum"),
      integer("free_links", 10L, {1, 1000}, "links of the free chain"),
      real("gravity", 1.0, "l/t^2", {0, 1e3}, "gravity on the pendulum"),
      choice("scheme", std::string("one_step"),
             {"one_step", "triple_jump", "suzuki", "conservative", "conservative_suzuki"},
             "the scheme that is judged; all are drawn"),
      real("time", 5.0, "t", {1e-3, 1e3}, "when the error is taken"),
      real("tau", 0.0125, "t", {1e-6, 10}, "middle one of the steps for accuracy: 8 tau to tau/4"),
      real("long_tau", 0.01, "t", {1e-6, 10}, "step of the long runs"),
      integer("long_steps", {30000, 1000000, 10000000}, {1, 1e9}, "steps of the long runs"),
  };
  c.published = {{.tiles = {"frank-integrator"}, .stated = {"scheme"}}};
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::one_step_scheme
