// Jumps and fronts that the conservative particle method carries exactly, whatever the number of particles; the cases
// of validation/bore and validation/hydraulic_jump have the widths, and what the ends of the channel let in.
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/error_measures.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "verification/check.hpp"

namespace seiche::verification::particles_jumps_test {

using namespace shallow_water_particles;
using shallow_water::ProfileError;

constexpr double gravity = 9.81;
const std::string source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method";

Piston piston(double velocity) {
  return {[velocity](double) { return velocity; }};
}

template <class Exact>
ProfileError reconstructed(const ParticleFlow& flow, const Exact& exact) {
  const auto now = [&](double x) { return exact.at(x, flow.time()); };
  return reconstruction_error(flow.measured_profile(), now, exact.breakpoints(flow.time()));
}

// About a hundred rounded operations per particle and step reach each edge; velocities are differences of celerities.
Roundoff rounding(long steps, double scale) {
  return {100.0 * static_cast<double>(steps), scale,
          "a hundred rounded operations per particle and step; scale is the celerity (depth) that is rounded"};
}

TEST_CASE("an isolated bore is exact to round-off and loses energy at the exact rate", "[conservation]") {
  Check check("particles_bore", "Bore 2 | 1: exact with one transition particle",
              "A bore runs 43 m over still water. The discontinuity lies inside one particle and passes to the next "
              "with exact time averages of edge velocity and pressure, so the reconstructed profile has no "
              "discretisation error: only rounding remains. Across the discontinuity the energy of the reconstruction "
              "must fall at $g (h_1-h_0)^3 a/(4 h_1)$, the rate of the jump relations.",
              source);
  const exact::Bore exact(gravity, 1, 2, 0, 40);
  const double u = exact.behind_velocity();
  ParticleFlow flow(bore(gravity, 0, 40, 120, 2, 1, 120), {piston(u), Wall{}});
  const double start = flow.energy();
  const int steps = 100;
  Worst deviation;
  for (int k = 0; k < steps; ++k) {
    flow.advance(0.08);
    const double work = flow.ledger().left_impulse.value() * u;
    deviation.add(start + work - flow.energy() - exact.energy_loss_rate() * flow.time());
  }
  check.at("N = 120, tau = 0.08 s, 100 steps");
  check.that("alone", "The number of second jumps detected beside an isolated bore is zero.",
             "jumps dropped beside a larger one", {static_cast<double>(flow.events().adjacent_discarded)},
             Bound{0, "the water on both sides is uniform"});
  const ProfileError error = reconstructed(flow, exact);
  check.from(source + ", fig. 12")
      .that("depth", "The depth reconstructed beside the bore is exact to round-off.", "L1 error of depth [m]",
            {error.depth.l1}, rounding(steps, 2));
  check.from(source + ", fig. 12")
      .that("velocity", "The velocity reconstructed beside the bore is exact to round-off.",
            "L1 error of velocity [m/s]", {error.velocity.l1}, rounding(steps, 5.4));
  check.from("Stoker, Water Waves (1957), ch. 10")
      .that("entropy", "Energy falls at the rate of the jump relations at every instant.",
            "largest deviation of the energy lost [m^4/s^2]", {deviation.value()},
            Roundoff{100, start, "one rounded work per step; scale is the energy"});
}

TEST_CASE("a bore reflects from a wall exactly, for ten particles as for a hundred", "[conservation]") {
  Check check("particles_bore_reflection", "Bore reflecting from a wall",
              "A bore with $h_1 = 1$, $u_1 = 1.3$ meets a wall. Incident and reflected jump are followed inside the "
              "particle at the wall, so the depth at the wall is the exact reflected depth for any number of "
              "particles. Tolerances count rounded operations.");
  const auto exact = exact::BoreReflection::from_velocity(gravity, 1, 1.3, 5, 10);
  for (const std::size_t count : {std::size_t{10}, std::size_t{100}}) {
    ParticleFlow flow(bore(gravity, 0, 5, 10, 1, exact.incident().ahead().depth, count), {piston(1.3), Wall{}});
    const int steps = static_cast<int>(13 * count);
    for (int k = 0; k < steps; ++k) flow.advance(2.6 / steps);
    const std::string n = fmt::format("_{}", count);
    const ProfileError error = reconstructed(flow, exact);
    check.holds("wall_depth" + n + ": Depth at the wall after reflection.", {flow.particles().depth(count - 1)},
                Roundoff{100.0 * steps, 1.45, "a hundred rounded operations a step", exact.reflected_depth()});
    check.holds("depth" + n + ": Reconstructed depth is exact.", {error.depth.l1}, rounding(steps, 1.45));
    check.holds("velocity" + n + ": Reconstructed velocity is exact.", {error.velocity.l1}, rounding(steps, 3.8));
  }
}

TEST_CASE("two bores collide exactly", "[conservation]") {
  Check check("particles_colliding_bores", "Two bores collide",
              "Bores of depths 2 and 1.5 run towards each other over depth 1 and pass through one another. While they "
              "share a few particles their positions are followed in mass coordinates; before and after, they are "
              "found from particle means. Two seconds after the collision the reconstructed profile is exact.");
  const exact::CollidingBores exact(gravity, 2, 1, 1.5, 30, 70);
  for (const std::size_t count : {std::size_t{200}, std::size_t{800}}) {
    ParticleFlow flow(uniform_stretches({{0, 30, exact.left()}, {30, 70, {1, 0}}, {70, 100, exact.right()}}, count),
                      {piston(exact.left().velocity), piston(exact.right().velocity)});
    march(flow, exact.collision_time() + 2);
    const ProfileError error = reconstructed(flow, exact);
    check.holds(fmt::format("depth_{}", count) + ": Reconstructed depth is exact after the collision.",
                {error.depth.l1}, rounding(flow.steps(), 2.7));
    check.holds(fmt::format("velocity_{}", count) + ": Reconstructed velocity is exact after the collision.",
                {error.velocity.l1}, rounding(flow.steps(), 5.2));
    check.holds(fmt::format("followed_{}", count) + ": The collision was followed once.",
                {static_cast<double>(flow.events().collisions)}, Bound{0, "a count", 1});
  }
}

TEST_CASE("a dry front moves with the exact velocity for any number of particles", "[conservation]") {
  Check check("particles_dry_front", "Front of a dam break on a dry bed",
              "The front particle carries a tip profile; its front moves at the constant velocity $2 c_1$, so the "
              "front is exact for ten particles. The discharge at the dam is $8 h_1 c_1/27$ at all times.");
  const exact::Ritter exact(gravity, 1, 10);
  for (const std::size_t count : {std::size_t{10}, std::size_t{100}}) {
    ParticleFlow flow(uniform_stretches({{0, 10, {1, 0}}}, count), {Wall{}, Vacuum{}});
    const int steps = static_cast<int>(39 * count / 10);
    Worst deviation;
    for (int k = 0; k < steps; ++k) {
      flow.advance(3.12 / steps);
      if (flow.time() > 0.5) deviation.add(flow.discharge(10) - exact.discharge_at_dam());
    }
    check.holds(fmt::format("front_{}", count) + ": Position of the front.", {flow.particles().edge.back()},
                Roundoff{static_cast<double>(steps), 29.5, "one rounded displacement per step", exact.front(3.12)});
    check.holds(fmt::format("discharge_{}", count) + ": Discharge at the dam after t = 0.5 s.", {deviation.value()},
                Bound{1.0 / static_cast<double>(2 * count),
                      "the section lies in one of N particles of depth ~1/2: half a particle's share"});
  }
}

}  // namespace seiche::verification::particles_jumps_test
