// Parts of the particle method that are known in closed form: mirrors at walls, fixed sections, jumps that leave their
// particle, the profile of a front.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/models/shallow_water_particles/row_kernels.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"
#include "verification/noise.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::particles_parts_test {

using namespace shallow_water_particles;

constexpr double g = 9.81;
const std::string source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method";

/// Largest differences of edges and velocities of a row and the right half of another.
double difference_from_half(const Particles& row, const Particles& whole) {
  const std::size_t shift = whole.size() - row.size();
  Worst worst;
  for (std::size_t i = 0; i < row.size(); ++i) {
    worst.add(row.edge[i + 1] - whole.edge[shift + i + 1]);
    worst.add(row.velocity[i] - whole.velocity[shift + i]);
  }
  return worst.value();
}

/// Ritter's fan c = (2 c0 - x/t)/3, u = 2 (c0 + x/t)/3 from time 1 on, between the water that was at `begin` then and
/// the fixed section x = 6, which it passes faster than its waves. What has left by time 1.5; `mirrored`: the other
/// way.
struct Outflow {
  double mass, momentum;
};

Outflow fan_through_section(std::size_t count, bool mirrored) {
  constexpr double begin = 0, end = 6;
  const double c0 = std::sqrt(g);
  const double sign = mirrored ? -1 : 1;
  const auto depth = [=](double x) { return std::pow((2 * c0 - sign * x) / 3, 2) / g; };
  const auto velocity = [=](double x) { return sign * 2 * (c0 + sign * x) / 3; };
  // A water column at x = 2 c0 t + K t^(2/3).
  const Piston follow{[=](double t) { return sign * (2 * c0 + 2 * (begin - 2 * c0) / (3 * std::cbrt(1 + t))); }};
  const Array edges = mirrored ? equal_width_edges(-end, -begin, count) : equal_width_edges(begin, end, count);
  ParticleFlow flow(particles_from_profile(edges, depth, velocity),
                    mirrored ? Ends{Open{}, follow} : Ends{follow, Open{}}, {.gravity = g});
  for (std::size_t k = 0; k < 6 * count; ++k) flow.advance(0.5 / static_cast<double>(6 * count));
  const Ledger& ledger = flow.ledger();
  return {-(mirrored ? ledger.left_mass : ledger.right_mass).value(),
          -sign * (mirrored ? ledger.left_impulse : ledger.right_impulse).value()};
}

TEST_CASE("a wall is a mirror", "[manufactured]") {
  Check check("particles_mirror", "A wall and its mirror image",
              "Half a basin with a wall in the middle, and the whole, whose flow is symmetric: 200 steps of a smooth "
              "slosh over a level bed and over one with a hump. The two agree to round-off at all levels of the "
              "method, because slopes and edge states at the wall equal the mirror image's. The moving half basin "
              "agrees likewise: its walls are pistons at 0.7 m/s, and everything but its motion is the same.");
  const Bed hump{[](double x) { return 0.2 * std::cos(x); }, [](double x) { return 0.2 * std::sin(x); }};
  constexpr int steps = 200;
  constexpr double tau = 0.01;
  const Roundoff rounding{.operations = 100 * steps,
                          .scale = std::sqrt(g),
                          .reason = "a hundred rounded operations per particle and step; scale is the celerity"};
  for (const bool uneven : {false, true}) {
    for (const Level level : {Level::godunov, Level::muscl}) {
      const auto slosh = [&](double left, std::size_t count, double carried) {
        Forcing forcing{.gravity = g};
        if (uneven) forcing.bed = hump;
        const auto depth = [&](double x) { return 1 + 0.1 * std::cos(x) - (uneven ? hump.elevation(x) : 0.0); };
        const auto velocity = [&](double x) { return carried + 0.1 * x * (9 - x * x); };
        const Piston wall{[carried](double) { return carried; }};
        ParticleFlow flow(particles_from_profile(equal_width_edges(left, 3, count), depth, velocity),
                          carried == 0 ? Ends{} : Ends{wall, wall}, forcing, {.level = level});
        for (int k = 0; k < steps; ++k) flow.advance(tau);
        return flow.particles();
      };
      const Particles half = slosh(0, 20, 0);
      check.holds("Half a basin behaves as half of the whole.", {difference_from_half(half, slosh(-3, 40, 0))},
                  rounding);
      if (uneven) continue;
      constexpr double speed = 0.7;
      Particles carried = slosh(0, 20, speed);
      for (double& x : carried.edge) x -= speed * tau * steps;
      for (double& u : carried.velocity) u -= speed;
      check.holds("The flow in a moving basin equals the flow in a basin at rest.",
                  {difference_from_half(carried, half)}, rounding);
    }
  }
}

TEST_CASE("water that leaves through a section takes its mass and momentum along", "[manufactured]") {
  Check check("particles_outflow", "A fan through a fixed section",
              "Ritter's fan passes the section $x = 6$ at supercritical speed for half a second; its other end follows "
              "the water. Mass $\\int h u\\,dt$ and momentum $\\int (h u^2 + g h^2/2)\\,dt$ that have passed, against "
              "their integrals. To the left the same, bitwise identical except for the order of sums.",
              "Ritter (1892)");
  const double c0 = std::sqrt(g);
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  const auto passed = [&](bool momentum) {
    return Gauss::integrate(
        [&](double t) {
          const double h = std::pow((2 * c0 - 6 / t) / 3, 2) / g;
          const double u = 2 * (c0 + 6 / t) / 3;
          return momentum ? h * u * u + g * h * h / 2 : h * u;
        },
        1.0, 1.5);
  };
  Worst asymmetry;
  const Order second{2, 0.3, "second order in width and step: the state at a section is taken at the middle of a step"};
  refine(check, {.axis = "width", .sizes = widths(6, {40, 80, 160, 320, 640}), .floor = 1e-12},
         {{"mass", "The error of the outflow mass converges at second order.", second},
          {"momentum", "The error of the outflowing momentum is second-order in the particle spacing.", second}},
         [&](double width) {
           const Outflow right = fan_through_section(cells_of(6, width), false);
           const Outflow left = fan_through_section(cells_of(6, width), true);
           asymmetry.add(right.mass - left.mass);
           asymmetry.add(right.momentum - left.momentum);
           return std::array{std::abs(right.mass - passed(false)), std::abs(right.momentum - passed(true))};
         });
  check.from(source).that(
      "mirrored", "The fluxes to the left equal the mirrored fluxes to the right.",
      "largest difference of mass or momentum", {asymmetry.value()},
      Roundoff{
          100.0 * 6 * 640, passed(true),
          "a hundred rounded operations per step near the section, of numbers up to the momentum that has passed"});
}

TEST_CASE("a particle behind a discontinuity has the state behind it", "[manufactured]") {
  Check check("particles_hand_over", "A jump that leaves its particle",
              "A particle of mass 0.7 contains a discontinuity between two given states; its depth and its velocity do "
              "not belong to a single position of the discontinuity, as between non-uniform particles. The edge behind "
              "moves with the water behind and bears its thrust; the one ahead gets the averages of the step in which "
              "the discontinuity leaves. After it the particle has the depth behind, by its volume, and the velocity "
              "behind, by its momentum. Discontinuities move to the right and to the left.");
  const State behind{2, shallow_water::velocity_change(g, 2, 1)};
  const State ahead{1, 0};
  const double mass = 0.7;
  for (const bool right : {true, false}) {
    const double sign = right ? 1 : -1;
    const State back{behind.depth, sign * behind.velocity};
    // A third of the mass is behind by volume, two fifths by momentum.
    const State mean{1 / (1.0 / 3 / behind.depth + 2.0 / 3 / ahead.depth), 0.4 * back.velocity};
    const auto jump = right ? jump_between(g, back, mean, ahead, 0.02) : jump_between(g, ahead, mean, back, 0.02);
    REQUIRE(jump.has_value());
    const double tau = 0.95 * mass / jump->mass_flux;
    double velocity = ahead.velocity;
    double thrust = shallow_water::thrust(g, ahead.depth);
    hand_over(g, *jump, mass, tau, velocity, thrust);
    const double width = mass / mean.depth + sign * tau * (velocity - back.velocity);
    const double momentum = mass * mean.velocity + sign * tau * (shallow_water::thrust(g, back.depth) - thrust);
    const auto claim = [&](const std::string& text, double value, double expected) {
      check.holds(
          (right ? "right-" : "left-") + text, {value},
          Roundoff{60, std::abs(expected) + 5, "some sixty operations on numbers up to the celerity", expected});
    };
    claim("The depth of the particle from its volume equals the depth behind the bore.", mass / width, back.depth);
    claim("The velocity of the particle from its momentum equals the velocity behind the bore.", momentum / mass,
          back.velocity);
  }
}

TEST_CASE("every discontinuity between two particles is found", "[manufactured]") {
  Check check("particles_suspects", "Where jumps are looked for",
              "Ten thousand pairs of states that approach each other, with depths up to a tenth apart. Wherever the "
              "depth of two waves between them exceeds the threshold the particle is a candidate; where depths and "
              "velocities account for less than a quarter of it, it is not.",
              source);
  Noise noise(4);
  double missed = 0, needless = 0, jumps = 0, calm = 0;
  constexpr double threshold = 0.02;
  const double quarter = std::sqrt(1 + threshold / 4) - 1;
  for (int k = 0; k < 10000; ++k) {
    const double size = k % 2 == 0 ? 1 : 0.03;
    const State left{1 + 0.05 * size * noise(), 0.15 * size * std::abs(noise())};
    const State right{1 + 0.05 * size * noise(), -0.15 * size * std::abs(noise())};
    const double low = std::min(left.depth, right.depth), high = std::max(left.depth, right.depth);
    const std::array depth{left.depth, 1.0, right.depth};
    const std::array velocity{left.velocity, 0.0, right.velocity};
    const bool suspect = may_hold_jump(&depth[1], &velocity[1], g, threshold, 1);
    const bool jump = shallow_water::two_rarefaction_depth(g, left, right) > (1 + threshold) * low;
    const bool level = high < (1 + threshold / 4) * low &&
                       left.velocity - right.velocity < 2 * quarter * shallow_water::celerity(g, low);
    missed += jump && !suspect ? 1 : 0;
    needless += level && suspect ? 1 : 0;
    jumps += jump ? 1 : 0;
    calm += level ? 1 : 0;
  }
  check.holds("The number of missed particles with a jump is zero.", {missed}, Bound{0, "a necessary condition"});
  check.holds("The number of examined particles in calm water is zero.", {needless},
              Bound{0, "either half of a rise of 2 % comes from the depths or from the velocities"});
  CHECK((jumps > 1000 && calm > 1000));
}

TEST_CASE("every stretch of water has a particle, and two discontinuities that have met are reported",
          "[manufactured]") {
  const Particles thin = uniform_stretches({{0, 1, {1, 0}}, {1, 1 + 1e-6, {2, 0}}}, 10);
  CHECK((thin.size() == 10 && thin.edge[9] == 1));
  CHECK(thin.depth(9) == Approx(2));

  const double speed = shallow_water::velocity_change(g, 2, 1);
  const double flux = shallow_water::jump_mass_flux(g, 1, 2);
  const auto jump = [&](std::size_t particle, Facing facing) {
    InteriorJump one;
    one.particle = particle;
    one.facing = facing;
    one.ahead = {1, 0};
    one.behind = {2, facing == Facing::right ? speed : -speed};
    one.behind_by_volume = one.behind_by_momentum = 0.5;
    one.mass_flux = flux;
    return one;
  };
  const Array mass(12, 1.0);
  Collision collision(g, jump(3, Facing::right), jump(8, Facing::left), mass);
  const double tau = 0.5 / collision.fastest_mass_flux();
  for (int k = 0; k < 16; ++k) {
    CHECK(collision.met() == (k * tau > 2.5 / flux));
    collision.advance(tau, mass);
  }
}

TEST_CASE("the profile of a front has the mass and momentum of its particle", "[manufactured]") {
  Check check("particles_tip_profile", "The profile of a front particle",
              "Depth $h_e s^\\pi$ and velocity $u_f - 2 \\sqrt{g h}$ for $0 < s < 1$, integrated in closed form: the "
              "mean depth is $h_e/(\\pi + 1)$, the momentum $h_e u_f/(\\pi + 1) - 2 \\sqrt{g} h_e^{3/2}/(1.5 \\pi + "
              "1)$. Fronts vary from a rectangle's to a parabola's.");
  const State mean{0.3, 1.2};
  const double c = shallow_water::celerity(g, mean.depth);
  Worst masses, momenta;
  for (const double ratio : {1.0, 1.02, 1.1, 1.2, 1.29}) {
    const TipProfile tip = tip_profile(g, mean, mean.velocity + 2 * ratio * c, 10);
    const double e = tip.exponent;
    masses.add(tip.edge_depth / (e + 1) - mean.depth);
    momenta.add(tip.edge_depth * tip.front_velocity / (e + 1) -
                2 * std::sqrt(g) * std::pow(tip.edge_depth, 1.5) / (1.5 * e + 1) - mean.depth * mean.velocity);
  }
  all_hold(
      check,
      Roundoff{100, 2, "the exponent is found to a rounding by halving; momenta up to 2, in some thirty operations"},
      {{"The mass under the tip's profile equals the particle's mass.", masses.value()},
       {"The error of the outflowing momentum is second-order in the particle spacing.", momenta.value()}});
}

}  // namespace seiche::verification::particles_parts_test
