// Water of the plan model without walls or without gravity: momenta, energy to round-off, whatever the solver leaves.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/scheme.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"
#include "verification/conservation/dispersive_plan_problems.hpp"

namespace seiche::verification::dispersive_plan_invariants_test {

using namespace dispersive_shallow_water_2d;
using namespace mechanics;
using linear::SolverMethod;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 4.2";

constexpr double tau = 0.03;
constexpr int steps = 100;

InvariantsLedger run(PlanProblem& problem, Scheme scheme) {
  return watched_run(problem, scheme, tau, steps);
}

double largest_momentum_of_a_node(const PlanProblem& problem) {
  Largest largest;
  const std::size_t n = problem.model.nodes();
  for (std::size_t i = 0; i < 3 * n; ++i) {
    largest.add(problem.model.node_masses()[i % n] * std::abs(problem.start.u[i]));
  }
  return largest.value();
}

/// Rounding of the momenta of all nodes, each of which changes by the forces of four cells in a step.
Roundoff rounding(const PlanProblem& problem, double arm) {
  return {
      .operations = 32.0 * steps * static_cast<double>(problem.model.nodes()),
      .scale = largest_momentum_of_a_node(problem) * arm,
      .reason =
          "a node's momentum (times its largest distance from the axis) is rounded some 32 times in each of 100 steps"};
}

TEST_CASE("water in plan that no side holds keeps its horizontal momenta to round-off", "[conservation]") {
  Check check("dispersive_plan_free_blob", "Water in plan without walls: invariants",
              "24 x 24 cells of half a depth, off a square at random, sheared and stirred at random, without walls, "
              "100 steps of 0.03. Momentum along x and y and angular momentum about the vertical are kept for any "
              "multipliers: the solver's tolerance is 1e-6 in one run and 1e-13 in the other. The blob stands on its "
              "bottom with nothing around it, or lies in still water: elevations count from its level, and a side "
              "without a wall feels that water's pressure. Energy of the one-step scheme errs by $O(\\tau^2)$ and is "
              "shown; the fully conservative scheme keeps it to round-off.");
  for (const bool stands : {true, false}) {
    const std::string where = stands ? "standing" : "in-still-water";
    for (const double tolerance : {1e-6, 1e-13}) {
      PlanProblem problem = free_blob(stands, {.solver = SolverMethod::iterative, .tolerance = tolerance});
      const InvariantsLedger ledger = run(problem, {});
      const std::string id = where + (tolerance == 1e-6 ? "-loose-" : "-tight-");
      const auto keeps = [&](const std::string& what, double value, double arm) {
        check.holds(id + what + ": " + what + " to round-off.", {value}, rounding(problem, arm));
      };
      keeps("momentum",
            worst(std::array{ledger.entry("momentum_x").largest_defect, ledger.entry("momentum_y").largest_defect}), 1);
      keeps("angular-momentum", ledger.entry("angular_momentum_z").largest_defect, 12);
    }
    PlanProblem problem = free_blob(stands, {.solver = SolverMethod::banded});
    const InvariantsLedger ledger = run(problem, {.stepping = Stepping::conservative});
    const auto keeps = [&](const std::string& what, double value, const Roundoff& criterion) {
      check.holds(where + "-conservative-" + what + ": Fully conservative: " + what + " to round-off.", {value},
                  criterion);
    };
    keeps("momentum",
          worst(std::array{ledger.entry("momentum_x").largest_defect, ledger.entry("momentum_y").largest_defect}),
          rounding(problem, 1));
    const double energy = std::abs(ledger.entry("energy").initial);
    const auto nodes = static_cast<double>(problem.model.nodes());
    keeps("energy", ledger.entry("energy").largest_defect / energy,
          {.operations = 2 + 100 * steps / nodes,
           .scale = 1,
           .reason = "some 100 roundings in each of 100 steps of the energy's part at each of 625 nodes, a 625th of "
                     "it; squares add up; and of the energies themselves"});
    keeps("volumes",
          ledger.entry("volume_worst").largest_defect * static_cast<double>(problem.model.constraints()) /
              problem.model.mass(),
          {.operations = 100 * 12,
           .scale = 6 / 0.5,
           .reason = "12 rounded places, up to 6 depths, per step and over a cell's side, 0.5"});
  }
}

TEST_CASE("without gravity the plan model keeps its kinetic energy in a box", "[conservation]") {
  Check check("dispersive_plan_weightless", "Water in plan without gravity in a closed box",
              "20 x 20 cells in a box, a swirl and its squeezing, without gravity, 100 steps of 0.03. Kinetic energy "
              "changes by the multipliers times what the solver leaves of the rates of volumes, $\\tau \\lambda \\cdot "
              "(J \\tilde u)$: not at all with a tight tolerance.",
              source);
  PlanProblem problem(plan_hump_in_box(),
                      [](double x, double y) {
                        const double k = std::numbers::pi / 10;
                        return Velocity{0.3 * std::sin(k * x) * std::cos(k * y) + 0.1 * std::sin(2 * k * x),
                                        -0.3 * std::cos(k * x) * std::sin(k * y), 0};
                      },
                      {.gravity = 0, .solver = SolverMethod::iterative, .tolerance = 1e-13});
  const InvariantsLedger ledger = run(problem, {});
  const double relative = ledger.entry("energy").largest_defect / ledger.entry("energy").initial;
  check.that("energy", "Kinetic energy of the weightless body is conserved to round-off.",
             "largest relative defect of the kinetic energy",
             {.value = relative, .resolution = "tolerance 1e-13, tau = 0.03"},
             Roundoff{2 + 100 * 100.0 / 441, 1,
                      "some 100 roundings in each of 100 steps of the energy's part at each of 441 nodes, a 441st of "
                      "it; squares add up; and of the energies themselves"});
}

TEST_CASE("the plan model returns when its velocities are reversed", "[conservation]") {
  Check check("dispersive_plan_reversible", "Two-dimensional horizontal model: time reversal",
              "A hump in a box: 50 steps of 0.1, velocities reversed, 50 steps, velocities reversed. The one-step "
              "scheme over a level bottom, and the fully conservative scheme over a bump too: the velocities that the "
              "one-step scheme carries along an uneven bottom move its middle by $O(\\tau^3)$ on the way back. Direct "
              "solver, so that nothing depends on tolerances.");
  struct Way {
    std::string id;
    Lattice lattice;
    Scheme scheme;
  };
  for (const Way& way : {Way{"level", plan_hump_in_box(), {}},
                         Way{"level-conservative", plan_hump_in_box(), {.stepping = Stepping::conservative}},
                         Way{"bump-conservative", hump_over_bump(), {.stepping = Stepping::conservative}}}) {
    PlanProblem problem(way.lattice, {}, {.solver = SolverMethod::banded});
    SchemeStepper<Model> stepper(problem.model, way.scheme);
    State state = problem.start;
    const auto run_and_turn = [&] {
      for (int n = 0; n < 50; ++n) stepper.step(state, 0.1);
      for (double& u : state.u) u = -u;
    };
    run_and_turn();
    run_and_turn();
    check.holds("Every node returns to its start (" + way.id + ").", {largest_difference(state, problem.start)},
                Roundoff{100, way.lattice.x.back(),
                         "places up to the box's length are rounded once in each of 100 steps, and what is added to "
                         "them is small; sweeps begin anew from the step's beginning"});
  }
}

TEST_CASE("the plan model's volumes have no rates at the middle of a step", "[conservation]") {
  Check check("dispersive_plan_residual", "Two-dimensional horizontal model: linearised constraints",
              "The mean velocity of a step, $\\tilde u$, changes no volume at the step's middle: $J(\\tilde q) \\tilde "
              "u = 0$ to the solver's tolerance, relative to the right-hand side of its system.");
  for (const double tolerance : {1e-6, 1e-10}) {
    PlanProblem problem(plan_hump_in_box(), {}, {.solver = SolverMethod::iterative, .tolerance = tolerance});
    OneStep<Model> stepper(problem.model);
    State state = problem.start;
    Largest worst;
    for (int n = 0; n < 50; ++n) {
      // What the forces alone would do to the volumes.
      std::vector<double> middle = state.q;
      for (std::size_t i = 0; i < middle.size(); ++i) middle[i] += 0.05 * state.u[i];
      problem.model.linearise({state.time, 0.1}, middle);
      std::vector<double> kicked = state.u;
      problem.model.kick(0.05, kicked);
      std::vector<double> rates(problem.model.constraints());
      problem.model.constraint_rates(kicked, rates);
      std::vector<double> mean = state.u;
      stepper.step(state, 0.1);
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (mean[i] + state.u[i]);
      std::vector<double> left(rates.size());
      problem.model.constraint_rates(mean, left);
      double residual = 0, right_hand_side = 0;
      for (std::size_t s = 0; s < rates.size(); ++s) {
        residual += left[s] * left[s];
        right_hand_side += rates[s] * rates[s];
      }
      worst.add(std::sqrt(residual / right_hand_side));
    }
    check.holds(std::string(tolerance == 1e-6 ? "loose" : "tight") +
                    ": The mean velocity keeps the volumes to the solver's tolerance.",
                {worst.value() / tolerance},
                Bound{1.01, "the solver stops at its tolerance; its recursive residual is the true one to round-off"});
  }
}

}  // namespace seiche::verification::dispersive_plan_invariants_test
