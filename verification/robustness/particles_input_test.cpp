// What the particle method refuses, and how it says so.

#include "seiche/divergence.hpp"
#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/particles/as_written.hpp"
#include "verification/robustness/refusals.hpp"

namespace seiche::verification::particles_input_test {

using namespace shallow_water_particles;
using validation::AsWritten;

Particles still_water(std::size_t count = 10) {
  return uniform_stretches({{0, 10, {1, 0}}}, count);
}

TEST_CASE("bad particles, ends and steps are rejected with their name", "[robustness]") {
  Check check(
      "particles_bad_input", "Bad input of the particle method",
      "Each rejection is a std::invalid_argument, thrown before anything changes, whose message names the quantity.");
  Refusals refusals(check);
  const auto particles = refusals.of(still_water(), [](const Particles& p) { ParticleFlow flow(p); });
  refusals.refused({"number of particles"}, [] { ParticleFlow flow(still_water(3)); });
  particles({"edge"}, [](Particles& p) { p.edge[3] = p.edge[5]; });
  particles({"edge"}, [](Particles& p) { p.edge[3] = not_a_number; });
  particles({"velocity"}, [](Particles& p) { p.velocity[0] = not_a_number; });
  particles({"mass"}, [](Particles& p) { p.mass[2] = 0; });
  refusals.refused({"depth"}, [] { dam_break(0, 5, 10, {1, 0}, {0, 0}, 10); });
  refusals.refused({"velocity = nan", "finite"}, [] { uniform_stretches({{0, 10, {1, not_a_number}}}, 10); });
  const auto falling = [](double x) { return 2.25 - x; };
  const auto zero = [](double) { return 0.0; };
  refusals.refused({"mass[2]"}, [&] { ParticleFlow flow(particles_from_profile({0, 1, 2, 3, 4}, falling, zero)); });
  refusals.refused({"bore"}, [] { bore(9.81, 0, 5, 10, 1, 2, 10); });
  refusals.refused({"depth ahead", "= 0", "positive"}, [] { bore(9.81, 0, 5, 10, 2, 0, 10); });
  refusals.outside_ranges("Forcing", "gravity positive and finite; manning non-negative and finite", Forcing{},
                          [](const Forcing& f) { ParticleFlow(still_water(), {}, f); });
  refusals.outside_ranges("Scheme", "theta in [1, 2]; courant above 0 and at most 0.9", Scheme{},
                          [](const Scheme& s) { ParticleFlow(still_water(), {}, {}, s); });
  const Bed wrong{[](double x) { return x; }, [](double x) { return x; }};
  refusals.refused({"bed"}, [&] { ParticleFlow flow(still_water(), {}, {.bed = wrong}); });
  refusals.refused({"piston"}, [] { ParticleFlow flow(still_water(), {Piston{}, Wall{}}); });
  refusals.refused({"celerity"}, [] { ParticleFlow(still_water()).advance(1); });
  refusals.refused({"particle"}, [] {
    const double u = shallow_water::velocity_change(9.81, 8, 1);
    ParticleFlow flow(bore(9.81, 0, 5, 10, 8, 1, 10), {Piston{[u](double) { return u; }}, Wall{}});
    flow.advance(0.05);
    flow.advance(0.09);
  });
  refusals.refused({"wall velocity = 0 leaves a vacuum at x = 10"}, [] {
    Particles p = still_water();
    p.velocity.back() = -6.3;  // 2 c = 6.264
    ParticleFlow flow(p);
  });
  refusals.refused({"piston velocity = -6.3 leaves a vacuum at x = 0"}, [] {
    ParticleFlow flow(still_water(), {Piston{[](double) { return -6.3; }}, Wall{}});
  });
  refusals.refused({"piston velocity = 20 leaves a vacuum at x = 10, t = 0.11"}, [] {
    ParticleFlow flow(still_water(), {Wall{}, Piston{[](double t) { return t < 0.1 ? 0.0 : 20.0; }}});
    flow.advance(0.1);
    flow.advance(0.02);
  });
  refusals.refused({"piston"}, [] {
    ParticleFlow flow(still_water(), {Piston{[](double) { return 50.0; }}, Wall{}});
    flow.advance(0.1);
  });
}

TEST_CASE("a piston may recede up to the speed at which water follows", "[robustness]") {
  Check check("particles_piston_almost_escapes", "A piston that withdraws just below the limit",
              "Still water follows a piston up to twice its celerity. A piston at 0.99 of that speed causes no vacuum: "
              "the run continues with positive depths.");
  const double escape = 2 * shallow_water::celerity(9.81, 1);
  ParticleFlow flow(still_water(40), {Piston{[=](double) { return -0.99 * escape; }}, Wall{}});
  march(flow, 0.5);
  Smallest thinnest;
  for (std::size_t i = 0; i < flow.particles().size(); ++i) thinnest.add(flow.particles().depth(i));
  check.holds("Depths of all particles are positive while the piston almost escapes.",
              {thinnest.value() > 0 ? 1.0 : 0.0},
              Qualitative{"smallest depth positive", "the limit must admit every speed that the equations allow"});
}

TEST_CASE("a breakdown stops with time, step and position", "[robustness]") {
  Check check("particles_breakdown", "A run that breaks down says where",
              "A body force that becomes NaN after two steps: the run stops with seiche::Divergence that carries the "
              "time at the start of the failing step, the number of steps before it and the position.");
  const auto force = [](double x, double t) { return t > 0.1 && x > 7 ? not_a_number : 0.0; };
  ParticleFlow flow(still_water(), {}, {.body_force = force});
  double place = not_a_number;
  long step = 0;
  try {
    for (int k = 0; k < 10; ++k) flow.advance(0.05);
  } catch (const Divergence& error) {
    place = error.place();
    step = error.step();
  }
  check.holds("The run stops at the first bad value.", {step == 2 ? 1.0 : 0.0},
              Qualitative{"seiche::Divergence after 2 complete steps", "no result may follow from a NaN"});
  check.holds("The breakdown message states the position of the failure.", {place >= 5 && place <= 10 ? 1.0 : 0.0},
              Qualitative{"position within the stencil of x > 7", "the message must lead to the cause"});
}

TEST_CASE("a row of particles given as data conserves its momentum", "[robustness]") {
  Check check(
      "particles_as_written", "The rearrangement as it is written",
      "A dam break between free ends: momentum changes by the impulses of the ends, whose pressures remain "
      "hydrostatic; with the deep water on the right, where a sweep meets the bore from ahead, the bore travels "
      "equally far; pairs without room are rejected and leave the row unchanged.");
  AsWritten flow(dam_break(0, 20, 40, {2, 0}, {1, 0}, 60), {Free{}, Free{}});
  const auto momentum = [&flow] {
    double sum = 0;
    for (std::size_t i = 0; i < flow.size(); ++i) sum += flow.mass(i) * flow.velocity(i);
    return sum;
  };
  for (int k = 0; k < 40; ++k) flow.advance(0.05);
  check.holds(
      "The momentum is the time times the difference of the ends' thrusts.",
      {momentum() - flow.time() * 0.5 * 9.81 * (4 - 1)},
      Bound{2e-9 * 0.5 * 9.81 * (4 + 1) * 2,
            "densities that differ by 1e-9 are equal, so that the thrusts of the ends are known to 2e-9, for 2 s"});
  constexpr std::size_t count = 240;
  constexpr double width = 80.0 / count;
  AsWritten along(dam_break(0, 40, 80, {2, 0}, {1, 0}, count), {Free{}, Free{}});
  AsWritten against(dam_break(0, 40, 80, {1, 0}, {2, 0}, count), {Free{}, Free{}});
  for (int k = 0; k < 120; ++k) {
    along.advance(0.05);
    against.advance(0.05);
  }
  const double front = 40 + exact::Riemann(9.81, {2, 0}, {1, 0}).right_wave().fastest * along.time();
  Worst off;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    if (along.depth(i) > 1.2 && along.depth(i + 1) <= 1.2) off.add(along.edges()[i + 1] - front);
    if (against.depth(i) <= 1.2 && against.depth(i + 1) > 1.2) off.add(80 - against.edges()[i + 1] - front);
  }
  CHECK(off.count() == 2);
  check.holds("The bore position is exact for sweeps with and against its direction.", {off.value()},
              Bound{3 * width, "three particles, by which the order of the sweep moves the bore of figure 12"});
  AsWritten pressed(still_water(), {Piston{[](double) { return 5.0; }}, Wall{}});
  const auto press = [&] {
    for (int k = 0; k < 40; ++k) pressed.advance(0.1);
  };
  CHECK_THROWS_AS(press(), Divergence);
  CHECK(pressed.time() == Approx(0.1 * static_cast<double>(pressed.steps())));
}

}  // namespace seiche::verification::particles_input_test
