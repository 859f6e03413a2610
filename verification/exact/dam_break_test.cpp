#include <array>
#include <cmath>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "verification/exact/shallow_water_residual.hpp"
#include "verification/reference_digits.hpp"

namespace dam_break_test {

using namespace seiche;
using exact::Ritter;
using exact::Stoker;
using namespace seiche::verification;

constexpr double g = 9.81;
const std::string source = "Stoker, Water Waves (1957), section 10.8; 30-digit arithmetic";

TEST_CASE("plateau and bore of the dam break have every digit", "[exact]") {
  Check check("exact_dam_break_digits", "Dam break: plateau, bore speed and discharge",
              "Depth and velocity of the plateau and the speed of the bore for six depth ratios, the "
              "discharge at the dam and the critical ratio, against 30-digit arithmetic ($h_1 = 1$ m, "
              "$g = 9.81$ m/s²).");
  struct Row {
    const char* id;
    double ratio, depth, velocity, speed;
    int depth_decimals;
    int speed_decimals;
  };
  const std::array<Row, 6> rows{{
      {"0001", 0.001, 0.06682978341618493, 4.64480109042853, 4.715358835713267, 17, 14},
      {"001", 0.01, 0.1711789187064547, 3.672454604273148, 3.900304166346558, 16, 15},
      {"01", 0.1, 0.3961748167994429, 2.321354995640744, 3.105133650668213, 16, 15},
      {"03", 0.3, 0.5914327208261708, 1.446734376267801, 2.935998559266723, 16, 15},
      {"05", 0.5, 0.7269204461872864, 0.9233639019770798, 2.957918120187525, 16, 15},
      {"09", 0.9, 0.9493349745576919, 0.1607500848118738, 3.093255424639396, 16, 15},
  }};
  for (const Row& row : rows) {
    const Stoker dam(g, 1, row.ratio);
    const std::string id = row.id;
    check_digits(check, "depth-" + id, "plateau depth at h0/h1 = " + std::to_string(row.ratio), dam.plateau().depth,
                 row.depth, row.depth_decimals);
    check_digits(check, "velocity-" + id, "plateau velocity at h0/h1 = " + std::to_string(row.ratio),
                 dam.plateau().velocity, row.velocity, 14);
    check_digits(check, "speed-" + id, "bore speed at h0/h1 = " + std::to_string(row.ratio), dam.bore_speed(),
                 row.speed, row.speed_decimals);
  }
  check_digits(check, "discharge-dry", "discharge at the dam, dry bed", Ritter(g, 1).discharge_at_dam(),
               0.92802724523649, 14);
  check_digits(check, "discharge-03", "discharge at the dam, h0/h1 = 0.3", Stoker(g, 1, 0.3).discharge_at_dam(),
               0.85564604846882, 14);
  check_digits(check, "discharge-05", "discharge at the dam, h0/h1 = 0.5", Stoker(g, 1, 0.5).discharge_at_dam(),
               0.67121209961841, 14);
  check_digits(check, "critical-ratio", "critical depth ratio", Stoker::critical_ratio(), 0.13827014109599195552, 17);
}

TEST_CASE("the flow at the dam turns critical at the critical ratio", "[exact]") {
  Check check("exact_critical_ratio", "The critical ratio of the dam break",
              "At $r_c$ the plateau velocity equals its celerity and $h_* = 4 h_1/9$: the closed form is put "
              "back into the Riemann solver, which does not know it. Below $r_c$ the state at the dam is that "
              "of the dry bed.");
  check.source(source);
  const double ratio = Stoker::critical_ratio();
  const Stoker dam(g, 1, ratio);
  const double celerity = shallow_water::celerity(g, dam.plateau().depth);
  check.that({.id = "critical",
              .text = "Plateau velocity and celerity agree at the critical ratio.",
              .quantity = "u* - c*",
              .unit = "m/s"},
             {.value = dam.plateau().velocity - celerity},
             Roundoff{50, 5, "50 rounded operations on numbers up to 2 c1 < 7"});
  check.that({.id = "depth", .text = "The plateau is 4/9 of the depth behind the dam.", .quantity = "h*", .unit = "m"},
             {.value = dam.plateau().depth}, Roundoff{50, 1, "50 rounded operations on depths up to 1", 4.0 / 9.0});
  Worst worst;
  for (const double below : {0.001, 0.05, 0.1, 0.138}) {
    const auto state = Stoker(g, 1, below).at(0, 1);
    worst.add(state.depth - 4.0 / 9);
    worst.add(state.velocity - 2 * std::sqrt(g) / 3);
  }
  check.that({.id = "upstream-of-critical",
              .text = "Below the critical ratio the dam does not feel the water downstream.",
              .quantity = "difference of the state at the dam from the dry-bed state"},
             {.value = worst.value()}, Roundoff{20, 4, "20 rounded operations on velocities up to 4"});
}

TEST_CASE("dam-break mass and momentum follow from the integral laws", "[exact]") {
  Check check("exact_dam_break_integrals", "Dam break: integral laws and differential equations",
              "Over a reservoir wide enough for no wave to reach its ends mass is constant and momentum grows "
              "by the difference of the thrusts: $\\int h u\\,dx = t\\,g (h_1^2 - h_0^2)/2$. Inside the fan "
              "central differences of fourth order measure the residual of both equations; their "
              "error is known in closed form.");
  check.source(source);
  Worst mass;
  Worst momentum;
  Largest residual;
  for (const double h0 : {0.0, 0.001, 0.1, 0.5, 0.99}) {
    const exact::Riemann dam(g, {1, 0}, {h0, 0}, 20);
    const double t = 3;
    const auto mean = validation::cell_average(dam, 0, 60, t);
    mass.add(60 * mean.depth - (20 + 40 * h0));
    momentum.add(60 * mean.discharge - t * 0.5 * g * (1 - h0 * h0));
    if (h0 > 0.5) continue;  // the fan is narrower than the differences
    const double tail = dam.left_wave().slowest;
    const double end = dam.left_wave().fastest;
    const double x = 20 + t * (0.6 * tail + 0.4 * end);
    residual.add(
        verification::shallow_water_residual([&](double a, double b) { return dam.at(a, b); }, g, x, t, 0.02, 0.02));
  }
  check.that(
      {.id = "mass", .text = "Mass of the exact dam break is constant.", .quantity = "mass defect", .unit = "m^2"},
      {.value = mass.value()}, Roundoff{100, 60, "four pieces of ten points, sums up to 60"});
  check.that({.id = "momentum",
              .text = "Momentum grows by the thrust difference.",
              .quantity = "momentum defect",
              .unit = "m^3/s"},
             {.value = momentum.value()}, Roundoff{100, 60, "four pieces of ten points, sums up to 60"});
  check.that({.id = "residual",
              .text = "The rarefaction fan satisfies both shallow-water equations.",
              .quantity = "residual",
              .unit = "m^2/s^2"},
             {.value = residual.value()},
             Bound{1e-9,
                   "in x the fan is a quartic at most, exact for the difference; in t the error of the "
                   "discharge 2 (4 c1^3 - 3 c1 xi^2 + xi^3)/(27 g), xi = (x - dam)/t, is d^4/30 times its "
                   "fifth derivative, 9.2e-10 for d = 0.01, t = 3, xi = -2.6; round-off 1e-13"});
}

}  // namespace dam_break_test
