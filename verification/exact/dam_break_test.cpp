#include <array>
#include <cmath>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "verification/check.hpp"
#include "verification/exact/shallow_water_residual.hpp"

namespace seiche::verification::dam_break_test {

using namespace exact;

constexpr double g = 9.81;
const std::string source = "Stoker, Water Waves (1957), section 10.8; 30-digit arithmetic";

TEST_CASE("the flow at the dam turns critical at the critical ratio", "[exact]") {
  Check check(
      "exact_critical_ratio", "The critical ratio of the dam break",
      "At $r_c$ the plateau velocity equals its celerity and $h_* = 4 h_1/9$: the closed form is inserted into the "
      "Riemann solver, which is independent of it. Below $r_c$ the state at the dam is the same as on a dry bed.",
      source);
  const double ratio = Stoker::critical_ratio();
  const Stoker dam(g, 1, ratio);
  const double celerity = shallow_water::celerity(g, dam.plateau().depth);
  CHECK(std::abs(ratio - 0.13827014109599196) < 2e-15);
  check.that("critical", "Plateau velocity and celerity agree at the critical ratio.", "u* - c* [m/s]",
             {dam.plateau().velocity - celerity}, Roundoff{50, 5, "50 rounded operations on numbers up to 2 c1 < 7"});
  check.that("depth", "The plateau is 4/9 of the depth behind the dam.", "h* [m]", {dam.plateau().depth},
             Roundoff{50, 1, "50 rounded operations on depths up to 1", 4.0 / 9.0});
  Worst worst;
  for (const double below : {0.001, 0.05, 0.1, 0.138}) {
    const auto state = Stoker(g, 1, below).at(0, 1);
    worst.add(state.depth - 4.0 / 9);
    worst.add(state.velocity - 2 * std::sqrt(g) / 3);
  }
  check.that("upstream-of-critical",
             "The state at the dam below the critical ratio is independent of the downstream depth.",
             "difference of the state at the dam from the dry-bed state", {worst.value()},
             Roundoff{20, 4, "20 rounded operations on velocities up to 4"});
}

TEST_CASE("dam-break mass and momentum follow from the integral laws", "[exact]") {
  Check check("exact_dam_break_integrals", "Dam break: integral laws and differential equations",
              "Over a reservoir wide enough for no wave to reach its ends mass is constant and momentum grows by the "
              "difference of the thrusts: $\\int h u\\,dx = t\\,g (h_1^2 - h_0^2)/2$. Inside the fan central "
              "fourth-order differences measure the residual of both equations; their error is known in closed form.",
              source);
  Worst mass, momentum;
  Largest residual;
  for (const double h0 : {0.0, 0.001, 0.1, 0.5, 0.99}) {
    const exact::Riemann dam(g, {1, 0}, {h0, 0}, 20);
    const double t = 3;
    const auto mean = validation::cell_average(dam, 0, 60, t);
    mass.add(60 * mean.depth - (20 + 40 * h0));
    momentum.add(60 * mean.discharge - t * 0.5 * g * (1 - h0 * h0));
    if (h0 > 0.5) continue;  // the fan is narrower than the differences
    const double tail = dam.left_wave().slowest, end = dam.left_wave().fastest;
    const double x = 20 + t * (0.6 * tail + 0.4 * end);
    residual.add(
        verification::shallow_water_residual([&](double a, double b) { return dam.at(a, b); }, g, x, t, 0.02, 0.02));
  }
  check.that("mass", "Mass of the exact dam break is constant.", "mass error [m^2]", {mass.value()},
             Roundoff{100, 60, "four pieces of ten points, sums up to 60"});
  check.that("momentum", "Momentum grows by the thrust difference.", "momentum error [m^3/s]", {momentum.value()},
             Roundoff{100, 60, "four pieces of ten points, sums up to 60"});
  check.that("residual", "The residuals of both shallow-water equations in the rarefaction fan are below 1e-9.",
             "residual [m^2/s^2]", {residual.value()},
             Bound{1e-9,
                   "in x the fan is a quartic at most, exact for the difference; in t the error of the discharge 2 (4 "
                   "c1^3 - 3 c1 xi^2 + xi^3)/(27 g), xi = (x - dam)/t, is d^4/30 times its fifth derivative, 9.2e-10 "
                   "for d = 0.01, t = 3, xi = -2.6; round-off 1e-13"});
}

}  // namespace seiche::verification::dam_break_test
