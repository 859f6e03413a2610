// Particles under friction and before a piston: flows of which one number is known in closed form.
#include <cmath>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::particles_ends_test {

using namespace shallow_water_particles;

constexpr double g = 9.81;

TEST_CASE("friction slows a uniform stream according to Manning's law", "[manufactured]") {
  Check check("particles_friction", "Uniform stream under friction",
              "A stream of uniform depth and velocity between free ends obeys $u' = -k u |u|$, $k = g n^2/h^{4/3}$, "
              "hence $u = u_0/(1 + k u_0 t)$. The error falls with the square of the step.",
              "Manning's law, integrated");
  constexpr double depth = 0.3, velocity = 2, manning = 0.03, end = 4;
  const double rate = g * manning * manning / std::pow(depth, 4.0 / 3);
  const double exact = velocity / (1 + rate * velocity * end);
  refine(
      check, {.axis = "step", .sizes = widths(end, {40, 80, 160, 320, 640}), .floor = 1e-12},
      {{"order", "The velocity after four seconds is second-order in the step.",
        Order{2, 0.1, "a second-order scheme for an ordinary differential equation"}}},
      [&](double tau) {
        ParticleFlow flow(uniform_stretches({{0, 20, {depth, velocity}}}, 20), {Free{}, Free{}}, {.manning = manning});
        for (std::size_t k = cells_of(end, tau); k > 0; --k) flow.advance(tau);
        return std::abs(flow.particles().velocity[10] - exact);
      });
}

TEST_CASE("an accelerated piston bears the thrust of its simple wave", "[manufactured]") {
  Check check("particles_piston", "Accelerated piston",
              "A piston that moves into still water with velocity $v = b t^2$ makes a simple wave: until it breaks, "
              "the celerity at the piston is $c_0 + v/2$. The impulse it has given by then is the integral of the "
              "thrust $c^4/(2g)$.",
              "Stoker, Water Waves (1957), section 10.3");
  constexpr double b = 0.2, end = 2;
  const double c = std::sqrt(g);
  const double rise = 0.5 * b * end * end;
  // The binomial of (c + b t^2/2)^4, integrated term by term.
  const double fourth = c * c * c * c + 4 * c * c * c * rise / 3 + 6 * c * c * rise * rise / 5 +
                        4 * c * rise * rise * rise / 7 + rise * rise * rise * rise / 9;
  const double exact = 0.5 * fourth * end / g;
  refine(check, {.axis = "particle width", .sizes = widths(10, {40, 80, 160, 320}), .floor = 1e-12},
         {{"impulse", "The piston's impulse agrees with the simple wave, to second order.",
           Order{2, 0.3, "second order in width and step"}}},
         [&](double width) {
           const std::size_t count = cells_of(10, width);
           ParticleFlow flow(uniform_stretches({{0, 10, {1, 0}}}, count),
                             {Piston{[](double t) { return b * t * t; }}, Wall{}}, {});
           for (std::size_t k = 0; k < 3 * count; ++k) flow.advance(end / static_cast<double>(3 * count));
           return std::abs(flow.ledger().left_impulse.value() - exact);
         });
}

}  // namespace seiche::verification::particles_ends_test
