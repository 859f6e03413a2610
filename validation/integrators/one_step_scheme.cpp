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

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/integrators/integrator_runs.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;
using evidence::Role;
using evidence::Roundoff;
using mechanics::AdaptiveMethod;
using mechanics::Integrator;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 1.2";
const std::string digits = "computed once by an independent implementation";

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

  [[nodiscard]] const WorkPrecision& of(Integrator integrator) const {
    return std::find_if(fixed.begin(), fixed.end(), [&](const auto& entry) { return entry.first == integrator; })
        ->second;
  }
};
constexpr std::size_t middle = 3;  // the refinement whose step is the parameter tau

Curves measure_curves(Running& run, const ChainProblem& problem) {
  const double time = run.real("time");
  Curves curves;
  for (const double factor : {8.0, 4.0, 2.0, 1.0, 0.5, 0.25}) {
    curves.steps.push_back(std::max(1L, std::lround(time / (run.real("tau") * factor))));
  }
  const mechanics::State truth = adaptive_state(problem, time, 1e-14);
  // The error is proportional to the tolerance: a ninth of the difference, times a factor of safety of three.
  curves.uncertainty = distance(truth, adaptive_state(problem, time, 1e-13)) / 3;
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

/// What Frank says of his scheme, and of no other.
void claim_half_the_cost(Running& run, const WorkPrecision& own, const WorkPrecision& rk2, const std::string& range) {
  run.record.check({.id = "cost",
                    .text = "A step costs half of RK2's.",
                    .quantity = "solves of the scheme / solves of RK2",
                    .source = source},
                   {.value = own.solves[middle] / rk2.solves[middle], .resolution = "equal steps"},
                   Bound{.limit = 0, .reason = "one solve per step against two", .expected = 0.5});
  double equal_steps = 0;
  double equal_cost = 0;
  for (std::size_t i = 0; i < own.error.size(); ++i) {
    equal_steps = std::max(equal_steps, own.error[i] / rk2.error[i]);
    equal_cost = std::max(equal_cost, own.error[i] / error_at(rk2, own.solves[i]));
  }
  run.record.check({.id = "accuracy",
                    .text = "At equal steps the error is smaller than RK2's.",
                    .quantity = "largest error ratio, scheme / RK2",
                    .source = source},
                   {.value = equal_steps, .resolution = range}, Bound{1, "better means less than 1"});
  run.record.check({.id = "accuracy-at-equal-cost",
                    .text = "At equal numbers of solves it is smaller still.",
                    .quantity = "largest error ratio, scheme / RK2",
                    .source = source},
                   {.value = equal_cost, .resolution = range}, Bound{1, "better means less than 1"});
}

void claim_cost_and_accuracy(Running& run, const Curves& curves) {
  const Integrator scheme = judged(run.values());
  const WorkPrecision& own = curves.of(scheme);
  const WorkPrecision& rk2 = curves.of(Integrator::runge_kutta_2);
  const std::string range = fmt::format("{} .. {} steps", curves.steps.front(), curves.steps.back());
  run.record.measure("reference_uncertainty", curves.uncertainty);
  run.record.measure("cpu_time_of_rk2_over_own", rk2.cpu.back() / own.cpu.back());
  if (scheme == Integrator::one_step) claim_half_the_cost(run, own, rk2, range);
  const bool fourth = order(scheme) == 4;
  run.record.check({.id = "order",
                    .text = fmt::format("The scheme is of order {}.", order(scheme)),
                    .quantity = "order of the largest coordinate error",
                    .source = source},
                   evidence::observed_order(own.tau, own.error, 10 * curves.uncertainty),
                   evidence::Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.1,
                                   "smooth motion; errors below ten times that of the reference are left out"});
}

void claim_digits(Running& run, const Curves& curves) {
  const std::vector<std::pair<Integrator, double>> expected = {
      {Integrator::one_step, 1.65e-5},     {Integrator::runge_kutta_2, 2.15e-4}, {Integrator::rattle, 1.29e-4},
      {Integrator::conservative, 1.79e-4}, {Integrator::triple_jump, 1.2e-8},    {Integrator::runge_kutta_4, 3.9e-8},
      {Integrator::suzuki, 1.9e-10},
  };
  for (const auto& [integrator, error] : expected) {
    const double unit = error < 2e-8 || integrator == Integrator::runge_kutta_4 ? 0.05 : 0.005;
    const double last_digit = unit * std::pow(10, std::floor(std::log10(error)));
    run.record.check(
        {.id = fmt::format("digits-{}", name(integrator)),
         .text = fmt::format("Error of an independent implementation: {}.", title(integrator)),
         .quantity = "largest coordinate error",
         .source = digits},
        {.value = curves.of(integrator).error[middle],
         .uncertainty = curves.uncertainty,
         .resolution = fmt::format("{} steps", curves.steps[middle])},
        Bound{.limit = last_digit, .reason = "half a unit of the last digit that it gives", .expected = error});
  }
}

void draw_curves(evidence::Record& record, const Curves& curves) {
  auto& figure = record.figure("frank_integrator", "Half the cost of RK2, better accuracy",
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

struct History {
  Integrator integrator;
  KeptInvariants kept;
};

std::vector<History> follow_all(Running& run, const ChainProblem& problem, bool pinned, double done) {
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

void draw_histories(evidence::Record& record, const std::vector<History>& histories, bool pinned) {
  auto& figure = record.figure(pinned ? "pendulum" : "free_chain",
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

void tabulate(evidence::Record& record, const std::vector<History>& histories, bool pinned) {
  evidence::Table table{.id = pinned ? "pendulum" : "free_chain",
                        .title = pinned ? "Pendulum: largest defects" : "Free chain: largest defects",
                        .caption = "Over the whole run; a run that breaks down is given up to there.",
                        .columns = {{"integrator", ""},
                                    {"until", ""},
                                    {"energy", "1"},
                                    {"momentum", "1"},
                                    {"angular momentum", "1"},
                                    {"links", "1"}}};
  for (const History& history : histories) {
    const KeptInvariants& kept = history.kept;
    if (kept.time.empty()) continue;
    std::vector<std::variant<double, std::string>> row = {std::string(title(history.integrator)), kept.time.back(),
                                                          kept.energy.back()};
    row.emplace_back(pinned ? std::variant<double, std::string>("not kept: pin") : kept.momentum.back());
    row.insert(row.end(), {kept.angular_momentum.back(), kept.links.back()});
    table.rows.push_back(std::move(row));
  }
  record.table(std::move(table));
}

void claim_conservation(Running& run, const std::vector<History>& histories, bool pinned) {
  const Integrator scheme = judged(run.values());
  const KeptInvariants& kept =
      std::find_if(histories.begin(), histories.end(), [&](const History& h) { return h.integrator == scheme; })->kept;
  const std::string system = pinned ? "pendulum" : "free-chain";
  const double tau = run.real("long_tau");
  const auto steps = static_cast<double>(run.integer("long_steps"));
  // Where the multipliers of a free chain begin to alternate, rounding costs more: see the article.
  const double until = pinned ? steps : std::min(steps, 1e5);
  std::size_t last = kept.time.size() - 1;
  while (last > 0 && kept.time[last] > until * tau * (1 + 1e-9)) --last;
  const rigid_chain::Scales& scales = kept.scales[last];
  const auto claim = [&](const std::string& id, const std::string& text, double value, double over, double scale,
                         const std::string& reason) {
    run.record.check({.id = system + "-" + id, .text = text, .quantity = "largest defect", .source = source},
                     {.value = value, .resolution = fmt::format("tau = {:g}, {:g} steps", tau, over)},
                     Roundoff{.operations = over * static_cast<double>(stages(scheme)),
                              .scale = scale,
                              .reason = reason + ", once per solved stage"});
  };
  claim("energy", pinned ? "Energy of the pendulum is kept: its potential is linear." : "Energy of the chain is kept.",
        kept.energy[last], until, scales.energy, "rounding of T + |Pi|");
  if (!pinned) {
    claim("momentum", "So is its momentum.", kept.momentum[last], until, scales.momentum, "rounding of sum m|u|");
  }
  claim("angular-momentum",
        pinned ? "Angular momentum about the vertical through the pin is kept." : "So is its angular momentum.",
        kept.angular_momentum[last], until, scales.angular_momentum,
        "rounding of sum m|r||u|, which grows as a free chain leaves");
  if (scheme == Integrator::one_step) {
    const rigid_chain::Scales& whole = kept.scales.back();
    claim("links", "Links change only by (tau^2/8) times the square of the velocity across them.", kept.modified_links,
          steps, pinned ? 1 : whole.angular_momentum / whole.momentum,
          "a rounded coordinate, of the size of the distance from the origin");
  }
}

void claim_bounded(Running& run, const std::vector<History>& histories) {
  for (const History& history : histories) {
    if (history.integrator != Integrator::rattle) continue;
    run.record.check(
        {.id = "rattle",
         .text = "RATTLE's energy error is bounded.",
         .quantity = "largest energy defect of the pendulum",
         .source = "Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), IX; value " + digits},
        {.value = history.kept.energy.back(), .resolution = "tau = 0.01"},
        Bound{1.55e-4, "1.5e-4 over 1e6 steps, plus half a unit of its last digit"});
  }
}

void run(Running& run) {
  const ChainProblem pinned = pendulum(run.values());
  const Curves curves = measure_curves(run, pinned);
  run.progress(0.1);
  claim_cost_and_accuracy(run, curves);
  if (run.as_published()) claim_digits(run, curves);
  draw_curves(run.record, curves);
  for (const bool pin : {true, false}) {
    const std::vector<History> histories =
        follow_all(run, pin ? pinned : free_chain(run.values()), pin, pin ? 0.1 : 0.55);
    claim_conservation(run, histories, pin);
    if (pin && run.as_published()) claim_bounded(run, histories);
    draw_histories(run.record, histories, pin);
    tabulate(run.record, histories, pin);
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
      integer("long_steps", {100000, 1000000, 10000000}, {1, 1e9}, "steps of the long runs"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
