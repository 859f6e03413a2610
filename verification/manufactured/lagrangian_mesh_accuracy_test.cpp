// Time errors of the integrators on the two-dimensional Lagrangian mesh, against numbers known from elsewhere.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/mechanics/invariants.hpp"
#include "validation/instruments/mechanics/reference_integrators.hpp"
#include "verification/check.hpp"
#include "verification/conservation/lagrangian_mesh_problems.hpp"

namespace lagrangian_mesh_accuracy_test {

using namespace seiche::mechanics;
using namespace seiche::verification;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 2";
const std::string digits = "regression: computed once by an earlier program for the same equations";

struct Motion {
  MeshProblem (*make)();
  double time;
  double rate;  ///< at which it changes [1/s]
};

struct Result {
  State state;
  double largest_energy_defect = 0;
  double last_energy_defect = 0;
};

Result integrated(const Motion& motion, Integrator integrator, int steps) {
  MeshProblem problem = motion.make();
  Result result{problem.start};
  InvariantsWatch watch(problem.model, result.state);
  const StepFunction step = make_integrator(integrator, problem.model);
  for (int n = 0; n < steps; ++n) {
    step(result.state, motion.time / steps);
    watch.record(result.state);
  }
  const auto& energy = watch.ledger().entry("energy");
  result.largest_energy_defect = energy.largest_defect;
  result.last_energy_defect = std::abs(energy.defect);
  return result;
}

/// A number known from elsewhere and how many of its digits.
struct Known {
  double value;
  int printed;
};

struct Expected {
  int steps;
  Known error;
};

/// Errors of one integrator on a motion: digits, order, energy.
class Judge {
 public:
  Judge(Check& check, seiche::evidence::Panel& panel, const Motion& motion, const State& truth)
      : check_(check), panel_(panel), motion_(motion), truth_(truth) {}

  void order_and_digits(Integrator integrator, const std::vector<int>& steps, const std::vector<Expected>& expected,
                        double floor) {
    std::vector<double> tau;
    std::vector<double> error;
    for (const int n : steps) {
      tau.push_back(motion_.time / n);
      error.push_back(largest_difference(Input(integrated(motion_, integrator, n).state.q), truth_.q));
      for (const Expected& e : expected) {
        if (e.steps == n) known(integrator, error.back(), e.error);
      }
    }
    check_.that({.id = std::string(name(integrator)) + "-order",
                 .text = "The error falls with order " + std::to_string(order(integrator)) +
                         " in the step: " + std::string(title(integrator)) + ".",
                 .quantity = "order of the largest coordinate error",
                 .source = source},
                observed_order(tau, error, floor), expected_order(integrator, tau.front()));
    panel_.line(std::string(title(integrator)), tau, error, keeps_energy(integrator) ? Role::computed : Role::peer);
  }

  /// Energy defect at the end of so many steps, in units of `scale`.
  void energy(Integrator integrator, int steps, Known expected, double scale = 1) {
    known(integrator, integrated(motion_, integrator, steps).last_energy_defect / scale, expected);
  }
  void keeps_exactly(Integrator integrator, int steps, double scale) {
    check_.holds(std::string(title(integrator)) + ": energy to round-off.",
                 {integrated(motion_, integrator, steps).largest_energy_defect},
                 Roundoff{static_cast<double>(steps), scale, "one rounded energy per step"});
  }

 private:
  Order expected_order(Integrator integrator, double largest_step) const {
    const double theory = order(integrator);
    if (integrator == Integrator::one_step || integrator == Integrator::conservative ||
        integrator == Integrator::rattle) {
      return {theory, 2 * std::pow(motion_.rate * largest_step, 2),
              "a symmetric scheme errs in even powers of the step: the next term is about the square of the largest "
              "step times the rate of the motion, and halving the step changes the order by that; twice it"};
    }
    return {theory, theory == 4 ? 0.2 : 0.05, "smooth motion, steps far below its times"};
  }

  void known(Integrator integrator, double value, Known expected) {
    const double last_digit = std::pow(10, std::floor(std::log10(expected.value)) - expected.printed + 1);
    check_.holds(std::string(title(integrator)) + ": the number of an earlier program.", {value},
                 Bound{0.5 * last_digit, "half a unit of the last digit", expected.value});
  }

  Check& check_;
  seiche::evidence::Panel& panel_;
  const Motion& motion_;
  const State& truth_;
};

const std::vector<int> second_order_steps{50, 100, 200, 400};

TEST_CASE("a free patch of fluid: errors of the integrators", "[manufactured]") {
  Check check("lagrangian_mesh_patch_accuracy", "Free patch of fluid: errors of the integrators",
              "The sheared and bent patch at t = 1; the error is the largest of a coordinate against RK4 with 8192 "
              "steps.");
  const Motion motion{[] { return moving_patch(); }, 1, 1.2};  // the largest gradient of the velocity
  const State truth = integrated(motion, Integrator::runge_kutta_4, 8192).state;
  Judge judge(check,
              check.figure("patch", "Errors on the free patch", "Largest coordinate error against the step.")
                  .panel({.x = "tau", .y = "error", .log_x = true, .log_y = true}),
              motion, truth);
  const double floor = 1e-13;  // the rounding of the reference's 8192 steps
  const auto second = [&](Integrator integrator, double hundred, double four_hundred) {
    judge.order_and_digits(integrator, second_order_steps, {{100, {hundred, 3}}, {400, {four_hundred, 3}}}, floor);
  };
  second(Integrator::one_step, 2.53e-6, 1.58e-7);
  second(Integrator::conservative, 2.10e-6, 1.32e-7);
  second(Integrator::runge_kutta_2, 5.22e-6, 3.27e-7);
  second(Integrator::rattle, 3.39e-6, 2.12e-7);
  judge.order_and_digits(Integrator::runge_kutta_4, {10, 20, 40, 80, 100}, {{100, {1.7e-11, 2}}}, floor);
  judge.keeps_exactly(Integrator::one_step, 100, 0.9);
  judge.keeps_exactly(Integrator::conservative, 100, 0.9);
  judge.energy(Integrator::runge_kutta_2, 100, {1.1e-7, 2});
  judge.energy(Integrator::rattle, 100, {3.9e-8, 2});
  judge.energy(Integrator::runge_kutta_4, 100, {6e-13, 1});
}

TEST_CASE("sloshing water: errors of the integrators", "[manufactured]") {
  Check check("lagrangian_mesh_sloshing_accuracy", "Sloshing on a Lagrangian mesh: errors of the integrators",
              "Water in a box 6 depths long, 16 x 4 cells, is released with a surface of $0.1\\cos(\\pi x/6)$. Errors "
              "of a coordinate at t = 8, about two thirds of a period, against RK4 with 2560 steps. The potential "
              "energy is cubic: the one-step scheme keeps the energy to O(tau^2) only.");
  const Motion motion{[] { return sloshing(); }, 8, 0.9};  // frequency of the second harmonic
  const State truth = integrated(motion, Integrator::runge_kutta_4, 2560).state;
  Judge judge(check,
              check.figure("sloshing", "Errors of sloshing water", "Largest coordinate error against the step.")
                  .panel({.x = "tau", .y = "error", .log_x = true, .log_y = true}),
              motion, truth);
  const double floor = 1e-12;  // RK4's 3.1e-9 at 160 steps, 16^4 times less, and its rounding
  const std::vector<int> steps{80, 160, 320, 640};
  judge.order_and_digits(Integrator::one_step, steps, {{160, {1.74e-5, 3}}}, floor);
  judge.order_and_digits(Integrator::triple_jump, steps, {{160, {2.1e-9, 2}}}, floor);
  judge.order_and_digits(Integrator::conservative, steps, {{160, {4.02e-5, 3}}}, floor);
  judge.order_and_digits(Integrator::rattle, steps, {{160, {1.73e-5, 3}}}, floor);
  judge.order_and_digits(Integrator::runge_kutta_2, steps, {{160, {6.8e-5, 2}}}, floor);
  judge.order_and_digits(Integrator::runge_kutta_4, steps, {{160, {3.1e-9, 2}}}, floor);
  const MeshProblem problem = sloshing();
  judge.energy(Integrator::one_step, 160, {9.2e-5, 2}, problem.model.potential_energy(problem.start.q));
}

}  // namespace lagrangian_mesh_accuracy_test
