// A free patch of fluid: invariants, accuracy, reversal and frames, with numbers known from elsewhere.
#include <algorithm>
#include <cmath>
#include <string>

#include "seiche/mechanics/invariants.hpp"
#include "seiche/mechanics/named_integrator.hpp"
#include "verification/check.hpp"
#include "verification/conservation/free_patch.hpp"

namespace {

using namespace seiche::mechanics;
using namespace seiche::verification;
using seiche::evidence::Bound;
using seiche::evidence::Order;
using seiche::evidence::Roundoff;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), chapters 1 and 2";
const std::string digits = "computed once by an independent implementation";

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

struct Drift {
  double energy, momentum, angular_momentum, area;
  double modified_area = 0;  ///< largest change of V_s(r) - (tau^2/4) V_s(u)
};

Drift drift(Integrator integrator, double tau, int steps) {
  FreePatch patch(8);
  State state = patch.start();
  const StepFunction step = make_integrator(integrator, patch);
  InvariantsWatch watch(patch, state);
  std::vector<double> area(patch.constraints());
  std::vector<double> bending(patch.constraints());
  std::vector<double> first;
  double modified = 0;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) {
      step(state, tau);
      watch.record(state);
    }
    patch.constraint_values(state.q, area);
    patch.curvature(state.u, state.u, bending);
    for (std::size_t s = 0; s < area.size(); ++s) area[s] -= tau * tau / 8 * bending[s];
    if (n == 0) first = area;
    modified = std::max(modified, largest_difference(area, first));
  }
  const InvariantsLedger& ledger = watch.ledger();
  return {ledger.largest_defect("energy"), ledger.largest_defect("momentum"), ledger.largest_defect("angular_momentum"),
          ledger.largest_defect("volume_worst"), modified};
}

struct Result {
  State state;
  double energy = 0;
};

Result integrated(Integrator integrator, int steps) {
  FreePatch patch(8);
  Result result{patch.start()};
  InvariantsWatch watch(patch, result.state);
  const StepFunction step = make_integrator(integrator, patch);
  for (int n = 0; n < steps; ++n) {
    step(result.state, 1.0 / steps);
    watch.record(result.state);
  }
  result.energy = watch.ledger().largest_defect("energy");
  return result;
}

}  // namespace

TEST_CASE("a free patch of fluid keeps energy, momenta and areas", "[conservation]") {
  Check check(
      "free_patch_invariants", "Free patch of fluid: invariants",
      "Square of 8 x 8 cells of constant area, no potential, sheared and bent by its initial velocity, to t = 1. "
      "Areas are bilinear: $V_s(r) - (\\tau^2/4)V_s(u)$ is exactly constant with the one-step scheme, and $V_s$ "
      "itself with the fully conservative one. The limit 1e-13 is below "
      "$4\\epsilon\\sqrt{N}$ = 2.8e-13, one rounding of order 1 in each of $N$ = 1e5 steps.");
  FreePatch patch(8);
  const State start = patch.start();
  const Roundoff initial{.operations = 162 * 64, .scale = 1, .reason = "sums over 162 coordinates, each projected"};
  Roundoff energy = initial;
  energy.expected = 0.884486280096849;
  check.that({.id = "initial-energy",
              .text = "Kinetic energy of the projected velocity.",
              .quantity = "energy",
              .source = digits + " to 15 digits"},
             {.value = patch.kinetic_energy(start.q, start.u)}, energy);
  Roundoff angular = initial;
  angular.expected = 1.47566381695791;
  check.that({.id = "initial-angular-momentum",
              .text = "Angular momentum of the projected velocity.",
              .quantity = "angular momentum",
              .source = digits + " to 15 digits"},
             {.value = patch.angular_momentum(start.q, start.u)[0]}, angular);
  const auto keeps = [&](const std::string& id, const std::string& text, double value, const std::string& resolution) {
    check.that({.id = id, .text = text, .quantity = "largest defect", .source = source},
               {.value = value, .resolution = resolution},
               Bound{1e-13, "rounding of quantities of order 1 over up to 1e5 steps"});
  };
  struct Case {
    std::string id;
    double tau;
    int steps;
  };
  for (const Case& c : {Case{"fine", 1e-5, 100000}, Case{"coarse", 1e-3, 1000}}) {
    const Drift d = drift(Integrator::one_step, c.tau, c.steps);
    const std::string resolution = "tau = " + std::string(c.steps == 1000 ? "1e-3" : "1e-5");
    keeps(c.id + "-energy", "One-step: energy to round-off.", d.energy, resolution);
    keeps(c.id + "-momentum", "One-step: momentum to round-off.", d.momentum, resolution);
    keeps(c.id + "-angular-momentum", "One-step: angular momentum to round-off.", d.angular_momentum, resolution);
    keeps(c.id + "-modified-area", "One-step: V_s(r) - (tau^2/4) V_s(u) to round-off.", d.modified_area, resolution);
    if (c.steps == 1000) {
      check.that({.id = "area",
                  .text = "One-step: the area itself errs by O(tau^2).",
                  .quantity = "largest change of a cell's area",
                  .source = digits},
                 {.value = d.area, .resolution = resolution},
                 Bound{.limit = 0.05e-9, .reason = "half a unit of the last of two digits", .expected = 5.3e-9});
    }
  }
  const Drift implicit = drift(Integrator::conservative, 0.02, 50);
  keeps("conservative-energy", "Fully conservative: energy to round-off.", implicit.energy, "tau = 0.02");
  keeps("conservative-area", "Fully conservative: areas to round-off.", implicit.area, "tau = 0.02");
  keeps("conservative-momentum", "Fully conservative: momenta to round-off.",
        std::max(implicit.momentum, implicit.angular_momentum), "tau = 0.02");
}

TEST_CASE("a free patch of fluid: errors of the integrators", "[conservation]") {
  Check check("free_patch_accuracy", "Free patch of fluid: errors of the integrators",
              "The same patch at t = 1; the error is the largest of a coordinate against RK4 with 8192 steps.");
  const State truth = integrated(Integrator::runge_kutta_4, 8192).state;
  struct Expected {
    Integrator integrator;
    double hundred, four_hundred;
    double energy;  ///< at 100 steps; 0: to round-off
  };
  const std::vector<Expected> table = {{Integrator::one_step, 2.53e-6, 1.58e-7, 0},
                                       {Integrator::conservative, 2.10e-6, 1.32e-7, 0},
                                       {Integrator::runge_kutta_2, 5.22e-6, 3.27e-7, 1.1e-7},
                                       {Integrator::rattle, 3.39e-6, 2.12e-7, 3.9e-8},
                                       {Integrator::runge_kutta_4, 1.7e-11, 0, 6e-13}};
  auto& panel = check.figure("patch", "Errors on the free patch", "Largest coordinate error against the step.")
                    .panel({.x = "tau", .y = "error", .log_x = true, .log_y = true});
  const auto unit = [](double value, int printed) {
    return 0.5 * std::pow(10, std::floor(std::log10(value)) - printed + 1);
  };
  for (const Expected& expected : table) {
    const std::string id{name(expected.integrator)};
    const std::string who{title(expected.integrator)};
    const bool fourth = order(expected.integrator) == 4;
    std::vector<double> tau;
    std::vector<double> error;
    for (const int steps : fourth ? std::vector{10, 20, 40, 80, 100} : std::vector{50, 100, 200, 400}) {
      const Result result = integrated(expected.integrator, steps);
      tau.push_back(1.0 / steps);
      error.push_back(largest_difference(result.state.q, truth.q));
      const auto known = [&](const std::string& what, double value, double from_table, int printed) {
        check.that(
            {.id = id + what,
             .text = who + ": the number of an independent implementation.",
             .quantity = what == "-energy" ? "largest energy defect" : "largest coordinate error",
             .source = digits},
            {.value = value, .resolution = std::to_string(steps) + " steps"},
            Bound{
                .limit = unit(from_table, printed), .reason = "half a unit of the last digit", .expected = from_table});
      };
      if (steps == 100) known("-error-100", error.back(), expected.hundred, fourth ? 2 : 3);
      if (steps == 400) known("-error-400", error.back(), expected.four_hundred, 3);
      if (steps != 100) continue;
      if (expected.energy > 0) {
        known("-energy", result.energy, expected.energy, fourth ? 1 : 2);
      } else {
        check.that({.id = id + "-energy",
                    .text = who + ": energy to round-off.",
                    .quantity = "largest energy defect",
                    .source = source},
                   {.value = result.energy, .resolution = "100 steps"},
                   Roundoff{.operations = 100, .scale = 0.9, .reason = "one rounded energy per step"});
      }
    }
    check.that({.id = id + "-order",
                .text = who + ": order " + std::to_string(order(expected.integrator)) + ".",
                .quantity = "order of the largest coordinate error",
                .source = source},
               seiche::evidence::observed_order(tau, error, 1e-13),
               Order{fourth ? 4.0 : 2.0, fourth ? 0.2 : 0.05, "smooth motion, steps far below its times"});
    panel.line(who, tau, error, keeps_energy(expected.integrator) ? Role::computed : Role::peer);
  }
}

TEST_CASE("a free patch of fluid: reversal, turned and shifted frames", "[conservation]") {
  Check check(
      "free_patch_symmetries", "Free patch of fluid: symmetries of the scheme",
      "100 steps of 0.01, velocities reversed, 100 steps: the start returns. The patch turned by 0.7, or shifted "
      "by 1000: the same motion, to the rounding of the coordinates.");
  for (const Integrator integrator : {Integrator::one_step, Integrator::conservative}) {
    const std::string who{title(integrator)};
    const std::string id{name(integrator)};
    const auto after = [&](FreePatch& patch, State& state) {
      const StepFunction step = make_integrator(integrator, patch);
      for (int n = 0; n < 100; ++n) step(state, 0.01);
    };
    FreePatch patch(8);
    const State start = patch.start();
    State there = start;
    after(patch, there);
    State back = there;
    for (double& u : back.u) u = -u;
    after(patch, back);
    for (double& u : back.u) u = -u;
    const Roundoff rounding{.operations = 200 * 64.0,
                            .scale = 1,
                            .reason = "200 steps, each coordinate of order 1 rounded some 64 times in a step"};
    check.that({.id = id + "-reversal",
                .text = who + ": the start returns.",
                .quantity = "largest difference of a coordinate or a rate",
                .source = source},
               {.value = std::max(largest_difference(back.q, start.q), largest_difference(back.u, start.u)),
                .resolution = "tau = 0.01, 100 steps each way"},
               rounding);
    FreePatch turned(8, 0.7);
    State state = turned.start();
    after(turned, state);
    for (std::size_t i = 0; i < state.q.size(); i += 2) {
      const auto r = FreePatch::turned({state.q[i], state.q[i + 1]}, -0.7);
      std::copy(r.begin(), r.end(), state.q.begin() + static_cast<std::ptrdiff_t>(i));
    }
    check.that({.id = id + "-turned",
                .text = who + ": a turned patch moves likewise.",
                .quantity = "largest difference of a coordinate",
                .source = source},
               {.value = largest_difference(state.q, there.q), .resolution = "tau = 0.01, 100 steps"}, rounding);
    FreePatch shifted(8, 0, 1000);
    state = shifted.start();
    after(shifted, state);
    for (double& x : state.q) x -= 1000;
    Roundoff coarse = rounding;
    coarse.operations = 100;
    coarse.scale = 1000;
    coarse.reason = "one rounding of coordinates of 1000 per step; differences of neighbours inherit it";
    check.that({.id = id + "-shifted",
                .text = who + ": a shifted patch moves likewise.",
                .quantity = "largest difference of a coordinate",
                .source = source},
               {.value = largest_difference(state.q, there.q), .resolution = "tau = 0.01, 100 steps"}, coarse);
  }
}
