// Orders of the one-step scheme, its compositions and the integrators it is compared with.
#include <algorithm>
#include <cmath>
#include <string>

#include "seiche/samples.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "validation/instruments/mechanics/rigid_chain.hpp"
#include "verification/check.hpp"

namespace one_step_accuracy_test {

using namespace seiche::mechanics;
using namespace seiche::rigid_chain;
using seiche::Worst;
using namespace seiche::verification;

const std::string source = "Hairer, Lubich & Wanner, Geometric Numerical Integration, 2nd ed. (2006), II, VII";
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
              "largest of a coordinate against RK4 with 131072 steps.");
  const State truth = integrated(Integrator::runge_kutta_4, 1 << 17);
  auto& panel = check.figure("orders", "Orders of the integrators", "Largest coordinate error against the step.")
                    .panel({.x = "tau", .y = "error", .log_x = true, .log_y = true});
  Worst energy;
  for (const Integrator integrator : all_integrators) {
    const bool fourth = order(integrator) == 4;
    std::vector<double> tau;
    std::vector<double> error;
    for (const int steps : {50, 100, 200, 400, 800, 1600}) {
      const State state = integrated(integrator, steps, keeps_energy(integrator) ? &energy : nullptr);
      tau.push_back(end_time / steps);
      Worst farthest;
      for (std::size_t i = 0; i < truth.q.size(); ++i) farthest.add(state.q[i] - truth.q[i]);
      error.push_back(farthest.value());
    }
    // RK2 is not yet asymptotic at the largest steps.
    if (integrator == Integrator::runge_kutta_2) {
      tau.erase(tau.begin(), tau.begin() + 2);
      error.erase(error.begin(), error.begin() + 2);
    }
    check.that({.id = std::string(name(integrator)),
                .text = "The coordinate error of " + std::string(title(integrator)) + " has order " +
                        std::to_string(order(integrator)) + ".",
                .quantity = "order of the largest coordinate error",
                .source = source},
               observed_order(tau, error, 5e-12),
               Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.1,
                     "smooth motion; below 5e-12 the rounding of the 131072 steps of the reference counts"});
    panel.line(std::string(title(integrator)), tau, error,
               keeps_energy(integrator) ? seiche::evidence::Role::computed : seiche::evidence::Role::peer);
  }
  check.that(
      {.id = "energy",
       .text = "The one-step scheme, its conservative variant and their compositions keep the energy to round-off.",
       .quantity = "largest energy defect",
       .source = "Frank, Discrete models of incompressible fluid (1994), chapter 1"},
      {.value = energy.value(), .resolution = "50 .. 1600 steps"},
      Roundoff{16000, 3, "one rounded energy of order 3 in each of at most 16000 stages"});
}

}  // namespace one_step_accuracy_test
