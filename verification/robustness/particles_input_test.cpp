// What the particle method refuses, and how it says so.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "seiche/divergence.hpp"
#include "seiche/models/shallow_water_particles/as_written.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace particles_input_test {

using namespace seiche::shallow_water_particles;
using namespace seiche::verification;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Particles still_water(std::size_t count = 10) {
  return uniform_stretches({{0, 10, {1, 0}}}, count);
}

// The message of the std::invalid_argument that `action` must throw; empty when it does not.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST_CASE("bad particles, ends and steps are refused with their name", "[robustness]") {
  Check check("particles_bad_input", "Bad input of the particle method",
              "Each refusal is a std::invalid_argument, thrown before anything changes, whose message names the "
              "quantity.");
  const auto refused = [&](const std::string& id, const std::string& text, const std::string& word, auto action) {
    const std::string message = refusal(action);
    INFO(id << ": " << message);
    check.holds(id + ": " + text, {message.find(word) != std::string::npos ? 1.0 : 0.0},
                Qualitative{"std::invalid_argument whose message contains \"" + word + "\"", "input must be refused"});
  };
  refused("few", "Fewer than four particles.", "number of particles", [] { ParticleFlow flow(still_water(3)); });
  refused("order", "Edges that do not increase.", "edge", [] {
    Particles p = still_water();
    p.edge[3] = p.edge[5];
    ParticleFlow flow(p);
  });
  refused("nan_edge", "An edge that is not a number.", "edge", [] {
    Particles p = still_water();
    p.edge[3] = not_a_number;
    ParticleFlow flow(p);
  });
  refused("nan_velocity", "A velocity that is not a number.", "velocity", [] {
    Particles p = still_water();
    p.velocity[0] = not_a_number;
    ParticleFlow flow(p);
  });
  refused("mass", "A particle without mass.", "mass", [] {
    Particles p = still_water();
    p.mass[2] = 0;
    ParticleFlow flow(p);
  });
  refused("depth", "A dry stretch inside.", "depth", [] { dam_break(0, 5, 10, {1, 0}, {0, 0}, 10); });
  refused("expansion", "A bore that would gain energy.", "bore", [] { bore(9.81, 0, 5, 10, 1, 2, 10); });
  refused("gravity", "Gravity that is not positive.", "gravity", [] {
    Forcing forcing;
    forcing.gravity = 0;
    ParticleFlow flow(still_water(), {}, forcing);
  });
  refused("theta", "A limiter parameter above 2.", "theta", [] {
    Scheme scheme;
    scheme.theta = 2.5;
    ParticleFlow flow(still_water(), {}, {}, scheme);
  });
  refused("bed", "A bed whose primitive belongs to another bed.", "bed", [] {
    Forcing forcing;
    forcing.bed = seiche::Bed{[](double x) { return x; }, [](double x) { return x; }};
    ParticleFlow flow(still_water(), {}, forcing);
  });
  refused("piston", "A piston without a velocity.", "piston", [] {
    ParticleFlow flow(still_water(), {Piston{}, Wall{}});
  });
  refused("tau_celerity", "A step beyond the celerity limit.", "celerity",
          [] { ParticleFlow(still_water()).advance(1); });
  refused("tau_jump", "A step in which a jump would cross more than a particle.", "particle", [] {
    const double u = seiche::shallow_water::velocity_change(9.81, 8, 1);
    ParticleFlow flow(bore(9.81, 0, 5, 10, 8, 1, 10), {Piston{[u](double) { return u; }}, Wall{}});
    flow.advance(0.05);
    flow.advance(0.09);
  });
  refused("vacuum_wall", "Water that parts from a wall faster than it can follow.",
          "wall velocity = 0 leaves a vacuum at x = 10", [] {
            Particles p = still_water();
            p.velocity.back() = -6.3;  // 2 c = 6.264
            ParticleFlow flow(p);
          });
  refused("vacuum_piston", "A piston that leaves the water from the start.",
          "piston velocity = -6.3 leaves a vacuum at x = 0", [] {
            ParticleFlow flow(still_water(), {Piston{[](double) { return -6.3; }}, Wall{}});
          });
  refused("vacuum_later", "A piston that leaves the water later.",
          "piston velocity = 20 leaves a vacuum at x = 10, t = 0.11", [] {
            ParticleFlow flow(still_water(), {Wall{}, Piston{[](double t) { return t < 0.1 ? 0.0 : 20.0; }}});
            flow.advance(0.1);
            flow.advance(0.02);
          });
  refused("tau_piston", "A piston that would cross the first particle within the step.", "piston", [] {
    ParticleFlow flow(still_water(), {Piston{[](double) { return 50.0; }}, Wall{}});
    flow.advance(0.1);
  });
}

TEST_CASE("a piston may leave as fast as the water follows", "[robustness]") {
  Check check(
      "particles_piston_almost_escapes", "A piston that withdraws just below the limit",
      "Still water follows a piston up to twice its celerity. A piston with 0.99 of that is no vacuum: the run goes "
      "on, with positive depths.");
  const double escape = 2 * seiche::shallow_water::celerity(9.81, 1);
  ParticleFlow flow(still_water(40), {Piston{[=](double) { return -0.99 * escape; }}, Wall{}});
  march(flow, 0.5);
  seiche::Smallest thinnest;
  for (std::size_t i = 0; i < flow.particles().size(); ++i) thinnest.add(flow.particles().depth(i));
  check.holds("Depths of all particles stay positive while the piston almost escapes.",
              {thinnest.value() > 0 ? 1.0 : 0.0},
              Qualitative{"smallest depth positive", "the limit must not refuse what the equations allow"});
}

TEST_CASE("a breakdown stops with time, step and place", "[robustness]") {
  Check check("particles_breakdown", "A run that breaks down says where",
              "A body force that becomes NaN after two steps: the run stops with seiche::Divergence that carries the "
              "time at the start of the failing step, the number of steps before it and the place.");
  Forcing forcing;
  forcing.body_force = [](double x, double t) { return t > 0.1 && x > 7 ? not_a_number : 0.0; };
  ParticleFlow flow(still_water(), {}, forcing);
  bool stopped = false;
  double place = 0;
  long step = 0;
  try {
    for (int k = 0; k < 10; ++k) flow.advance(0.05);
  } catch (const seiche::Divergence& error) {
    stopped = true;
    place = error.place();
    step = error.step();
  }
  check.holds("The run stops at the first bad value.", {stopped && step == 2 ? 1.0 : 0.0},
              Qualitative{"seiche::Divergence after 2 complete steps", "nothing may be computed from a NaN"});
  check.holds("The breakdown message states the position of the failure.", {place >= 5 && place <= 10 ? 1.0 : 0.0},
              Qualitative{"place within the stencil of x > 7", "the message must lead to the cause"});
}

TEST_CASE("a row as it is written keeps its momentum and refuses by name", "[robustness]") {
  Check check("particles_as_written", "The rearrangement as it is written",
              "A dam break between free ends: momentum changes by the impulses of the ends, whose pressures stay those "
              "of still water; ends and steps that it has not, and pairs without room, are refused and leave it as it "
              "was.");
  AsWritten flow(dam_break(0, 20, 40, {2, 0}, {1, 0}, 60), {Free{}, Free{}});
  const auto momentum = [&flow] {
    double sum = 0;
    for (std::size_t i = 0; i < flow.size(); ++i) sum += flow.mass(i) * flow.velocity(i);
    return sum;
  };
  for (int k = 0; k < 40; ++k) flow.advance(0.05);
  check.holds("The momentum is the time times the difference of the ends' thrusts.",
              {momentum() - flow.time() * 0.5 * 9.81 * (4 - 1)},
              Bound{2e-9 * 0.5 * 9.81 * (4 + 1) * 2,
                    "densities that differ by 1e-9 are equal, so that the thrusts of the "
                    "ends are known to 2e-9, for 2 s"});
  const auto refused = [&](const std::string& id, const std::string& text, const std::string& word, auto action) {
    check.holds(id + ": " + text, {refusal(action).find(word) != std::string::npos ? 1.0 : 0.0},
                Qualitative{"std::invalid_argument whose message contains \"" + word + "\"", "input must be refused"});
  };
  refused("open", "A section that water passes.", "end", [] { AsWritten row(still_water(), {Open{}, Wall{}}); });
  refused("step", "A step of no length.", "tau", [&] { flow.advance(0); });
  AsWritten pressed(still_water(), {Piston{[](double) { return 5.0; }}, Wall{}});
  const auto press = [&] {
    for (int k = 0; k < 40; ++k) pressed.advance(0.1);
  };
  CHECK_THROWS_AS(press(), seiche::Divergence);
  CHECK(pressed.time() == Approx(0.1 * static_cast<double>(pressed.steps())));
}

}  // namespace particles_input_test
