// Time errors of the integrators on the two-dimensional Lagrangian mesh.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::lagrangian_mesh_accuracy_test {

using namespace mechanics;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 2";

struct Motion {
  MeshProblem (*make)();
  double time;
  double rate;  ///< at which it changes [1/s]
};

struct Result {
  State state;
  double energy_defect = 0;  ///< largest
};

Result integrated(const Motion& motion, Integrator integrator, long steps) {
  MeshProblem problem = motion.make();
  State state = problem.start;
  InvariantsWatch watch(problem.model, state);
  const StepFunction step = make_integrator(integrator, problem.model);
  for (long n = 0; n < steps; ++n) {
    step(state, motion.time / static_cast<double>(steps));
    watch.record(state);
  }
  return {state, watch.ledger().largest_defect("energy")};
}

Order expected_order(Integrator integrator, double rate) {
  const double theory = order(integrator);
  using enum Integrator;
  if (integrator == one_step || integrator == conservative || integrator == rattle) {
    return {theory, 2 * rate * rate,
            "a symmetric scheme errs in even powers of the step: the next term is about the square of the largest step "
            "times the rate of the motion, and halving the step changes the order by that; twice it"};
  }
  return {theory, theory == 4 ? 0.2 : 0.05, "smooth motion, steps far below its times"};
}

/// Orders of the largest error of a coordinate, against the state after so many steps of RK4.
void check_orders(Check& check, const Motion& motion, long finest, double floor,
                  const std::vector<std::pair<Integrator, std::vector<int>>>& integrators) {
  const State truth = integrated(motion, Integrator::runge_kutta_4, finest).state;
  for (const auto& [integrator, steps] : integrators) {
    const std::string id(name(integrator)), text(title(integrator));
    const std::vector<double> taus = widths(motion.time, steps);
    refine(check, {"step", taus, id, "Largest coordinate error: " + text, floor},
           {{id + "-order",
             "The error falls with order " + std::to_string(order(integrator)) + " in the step: " + text + ".",
             expected_order(integrator, motion.rate * taus.front())}},
           [&, integrator = integrator](double tau) {
             const Result found = integrated(motion, integrator, std::lround(motion.time / tau));
             return largest_difference(Input(found.state.q), truth.q);
           });
  }
}

TEST_CASE("a free patch of fluid: errors of the integrators", "[manufactured]") {
  Check check(
      "lagrangian_mesh_patch_accuracy", "Free patch of fluid: errors of the integrators",
      "The sheared and bent patch at t = 1; the error is the largest of a coordinate against RK4 with 8192 steps.",
      source);
  const Motion motion{[] { return moving_patch(); }, 1, 1.2};  // the largest gradient of the velocity
  const std::vector<int> steps{50, 100, 200, 400};
  check_orders(check, motion, 8192, 1e-13,  // the rounding of the reference's 8192 steps
               {{Integrator::one_step, steps},
                {Integrator::conservative, steps},
                {Integrator::runge_kutta_2, steps},
                {Integrator::rattle, steps},
                {Integrator::runge_kutta_4, {10, 20, 40, 80, 100}}});
  for (const Integrator integrator : {Integrator::one_step, Integrator::conservative}) {
    check.holds(std::string(title(integrator)) + ": energy to round-off.",
                {integrated(motion, integrator, 100).energy_defect}, Roundoff{100, 0.9, "one rounded energy per step"});
  }
}

TEST_CASE("sloshing water: errors of the integrators", "[manufactured]") {
  Check check("lagrangian_mesh_sloshing_accuracy", "Sloshing on a Lagrangian mesh: errors of the integrators",
              "Water in a box 6 h long, 16 x 4 cells, is released with a surface of $0.1\\cos(\\pi x/6)$. Errors of a "
              "coordinate at t = 8, about two thirds of a period, against RK4 with 2560 steps.",
              source);
  std::vector<std::pair<Integrator, std::vector<int>>> all;
  using enum Integrator;
  for (const Integrator integrator : {one_step, triple_jump, conservative, rattle, runge_kutta_2, runge_kutta_4}) {
    all.emplace_back(integrator, std::vector{80, 160, 320, 640});
  }
  // Frequency of the second harmonic; RK4's 3.1e-9 at 160 steps, 16^4 times less, and its rounding.
  check_orders(check, {[] { return sloshing(); }, 8, 0.9}, 2560, 1e-12, all);
}

}  // namespace seiche::verification::lagrangian_mesh_accuracy_test
