/*
A lake over an uneven bed must stay at rest: the thrusts on the two sides of every particle must balance the reaction of
the bed under it *in floating point*, not up to the truncation error. The bed is $z = 0.3\,e^{-(x-5)^2} + 0.05 \sin 3x$,
the surface at 0.8 m, as smooth as beds come but nowhere flat.

**What is compared.** The largest velocity and the largest displacement of an edge after many steps, with zero.

**What to look at.** The numbers: round-off, and no growth in time.
*/
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
namespace particles = shallow_water_particles;

constexpr double length = 10;

Bed bumps() {
  return {[](double x) { return 0.3 * std::exp(-(x - 5) * (x - 5)) + 0.05 * std::sin(3 * x); },
          [](double x) { return 0.15 * std::sqrt(std::numbers::pi) * std::erf(x - 5) - 0.05 / 3 * std::cos(3 * x); }};
}

void run(Running& run) {
  const double level = run.real("surface");
  const double gravity = run.real("gravity");
  const long steps = run.integer("steps");
  const auto n = static_cast<std::size_t>(run.integer("particles"));
  const Bed bed = bumps();
  const particles::Array edges = particles::equal_width_edges(0, length, n);
  // The primitive keeps the mean depth of every particle consistent with the bed that the method sees.
  particles::Particles initial = particles::particles_from_primitives(
      edges, [&](double x) { return level * x - bed.primitive(x); }, [](double) { return 0.0; });
  particles::ParticleFlow flow(std::move(initial), {}, {.gravity = gravity, .bed = bed});
  const double tau = run.real("courant") / 0.4 * flow.largest_step().tau;
  std::vector<double> time;
  std::vector<double> speed;
  double fastest = 0;
  for (long k = 0; k < steps; ++k) {
    flow.advance(tau);
    double now = 0;
    for (const double u : flow.particles().velocity) now = std::max(now, std::abs(u));
    fastest = std::max(fastest, now);
    if (k % std::max(1L, steps / 500) == 0) {
      time.push_back(flow.time());
      speed.push_back(std::max(now, 1e-18));
      run.progress(static_cast<double>(k) / static_cast<double>(steps));
    }
  }
  double drift = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) drift = std::max(drift, std::abs(flow.particles().edge[k] - edges[k]));
  run.record.measure("max_velocity", fastest);
  run.record.measure("edge_drift", drift);
  run.record.measure("mass_defect", flow.mass_defect());
  run.record.measure("momentum_defect", flow.momentum_defect());
  const std::string resolution = fmt::format("N = {}, {} steps", n, steps);
  run.record.check(
      {.id = "velocity",
       .text = "Water at rest stays at rest.",
       .quantity = "largest velocity at any step",
       .unit = "m/s",
       .source = "well-balanced bed reaction"},
      {.value = fastest, .resolution = resolution},
      evidence::Roundoff{
          .operations = 10 * static_cast<double>(steps),
          .scale = tau * gravity * level * static_cast<double>(n) / length,
          .reason = "each step kicks a particle by the round-off of some ten operations on thrusts g h^2/2 over its "
                    "mass; the kicks add up as a random walk"});
  run.record.check({.id = "drift",
                    .text = "No edge moves.",
                    .quantity = "largest displacement of an edge",
                    .unit = "m",
                    .source = "the same"},
                   {.value = drift, .resolution = resolution},
                   evidence::Roundoff{.operations = static_cast<double>(steps),
                                      .scale = length,
                                      .reason = "one rounded update of an edge of this size per step"});
  run.record.figure("velocity", "Largest velocity against time", "It stays at round-off.")
      .panel({.x = "t [s]", .y = "max |u| [m/s]", .log_y = true})
      .line("particles", time, speed, Role::computed);
  std::vector<double> x;
  std::vector<double> z;
  std::vector<double> surface;
  for (int k = 0; k <= 300; ++k) {
    x.push_back(length * k / 300);
    z.push_back(bed.elevation(x.back()));
    surface.push_back(level);
  }
  auto& lake = run.record.figure("lake", "The lake", "Bed and surface.")
                   .panel({.x = "x [m]", .y = "elevation [m]", .y_min = -0.1});
  lake.fill("water", x, surface, Role::water);
  lake.fill("bed", x, z, Role::bed);
}

}  // namespace

Case lake_at_rest_particles() {
  Case c;
  c.former_names = {"lake_at_rest"};
  c.title = "A lake at rest over an uneven bed";
  c.source = "E. Audusse et al., A fast and stable well-balanced scheme, SIAM J. Sci. Comput. 25 (2004) 2050";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("particles", 200L, {8, 1e5}, "particles of equal widths"),
      integer("steps", {10000, 200000, 1000000}, {1, 1e8}, "number of steps"),
      real("courant", 0.3, "1", {0.01, 0.4}, "Courant number of the step"),
      real("surface", 0.8, "m", {0.45, 10}, "elevation of the surface"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
