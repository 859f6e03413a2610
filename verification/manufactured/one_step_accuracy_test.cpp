// Orders of the one-step scheme, its compositions and the integrators it is compared with.
#include <cmath>
#include <string>

#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"
#include "verification/conservation/mechanical_problem.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::one_step_accuracy_test {

using namespace mechanics;
using namespace rigid_chain;

constexpr double end_time = 5;

State integrated(Integrator integrator, int steps, Worst* energy = nullptr) {
  RigidChain pendulum = double_pendulum();
  State state = spiral_start(pendulum);
  InvariantsWatch watch(pendulum, state);
  const StepFunction step = make_integrator(integrator, pendulum);
  for (int n = 0; n < steps; ++n) {
    step(state, end_time / steps);
    if (energy != nullptr) watch.record(state);
  }
  if (energy != nullptr) energy->add(watch.ledger().largest_defect("energy"));
  return state;
}

TEST_CASE("integrators of constrained systems have their orders", "[manufactured]") {
  Check check("integrator_orders", "Orders of the integrators of constrained systems",
              "Spherical double pendulum (unit links, masses 1 and 1.3, unit gravity) to $t = 5$; the error is the "
              "largest of a coordinate against RK4 with 131072 steps.",
              "Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), II, VII");
  const State truth = integrated(Integrator::runge_kutta_4, 1 << 17);
  Worst energy;
  for (const Integrator integrator : all_integrators) {
    const bool fourth = order(integrator) == 4;
    const std::string id(name(integrator)), text(title(integrator));
    // RK2 is not yet asymptotic at the largest steps.
    const std::vector<int> steps = integrator == Integrator::runge_kutta_2 ? std::vector{200, 400, 800, 1600}
                                                                           : std::vector{50, 100, 200, 400, 800, 1600};
    refine(check, {"step", widths(end_time, steps), id, text, 5e-12},
           {{id, "The coordinate error of " + text + " has order " + std::to_string(order(integrator)) + ".",
             Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.1,
                   "smooth motion; below 5e-12 the rounding of the 131072 steps of the reference counts"}}},
           [&](double tau) {
             const State state = integrated(integrator, static_cast<int>(std::lround(end_time / tau)),
                                            keeps_energy(integrator) ? &energy : nullptr);
             return largest_difference(Input(state.q), truth.q);
           });
  }
  check.from("Frank, Discrete models of incompressible fluid (1994), chapter 1")
      .that("energy",
            "The energy is conserved to round-off by the one-step scheme, its conservative variant and their "
            "compositions.",
            "largest energy error", {.value = energy.value(), .resolution = "50 .. 1600 steps"},
            Roundoff{16000, 3, "one rounded energy of order 3 in each of at most 16000 stages"});
}

}  // namespace seiche::verification::one_step_accuracy_test
