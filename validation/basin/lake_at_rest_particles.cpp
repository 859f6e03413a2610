/*
A lake over an uneven bed must stay at rest: the thrusts on the two sides of every particle must balance the reaction of
the bed under it *in floating point*, not up to the truncation error. The bed is $z = 0.3\,e^{-(x-5)^2} + 0.05 \sin 3x$,
the surface at 0.8 m, as smooth as beds come but nowhere flat.

**What is compared.** The largest velocity and the largest displacement of an edge after many steps, with zero.

**What to look at.** The numbers: round-off, and no growth in time.
*/
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases::lake_at_rest_particles {
namespace {

namespace particles = shallow_water_particles;

constexpr double length = 10;

Bed bumps() {
  return {[](double x) { return 0.3 * std::exp(-(x - 5) * (x - 5)) + 0.05 * std::sin(3 * x); },
          [](double x) { return 0.15 * std::sqrt(std::numbers::pi) * std::erf(x - 5) - 0.05 / 3 * std::cos(3 * x); }};
}

particles::ParticleFlow lake(const Values& values) {
  const double level = values.real("surface");
  const Bed bed = bumps();
  // The primitive keeps the mean depth of every particle consistent with the bed that the method sees.
  return {particles::particles_from_primitives(
              particles::equal_width_edges(0, length, static_cast<std::size_t>(values.integer("particles"))),
              [&](double x) { return level * x - bed.primitive(x); }, [](double) { return 0.0; }),
          {},
          {.gravity = values.real("gravity"), .bed = bed}};
}

double time_step(const particles::ParticleFlow& flow, const Values& values) {
  return values.real("courant") / 0.4 * flow.largest_step().tau;
}

struct Results {
  std::vector<double> time;   ///< every now and then
  std::vector<double> speed;  ///< largest at that time
  Worst velocity;             ///< at any step
  Worst drift;                ///< of edges, at the end
  double mass_defect = 0;
  double momentum_defect = 0;
};

void claims(const Values& values, const Claims<Results>& claims) {
  const long n = values.integer("particles");
  const double celerity = std::sqrt(values.real("gravity") * values.real("surface"));
  // Rounding errors do not add up: what disturbs the balance runs away as short waves, which the method damps.
  constexpr double two_edges = 2;
  const auto at_rest = claims.at(fmt::format("N = {}, {} steps", n, values.integer("steps")));
  at_rest.check(
      "velocity", "Water at rest stays at rest.", "largest velocity at any step [m/s]", &Results::velocity,
      Roundoff{.operations = two_edges,
               .scale = celerity * static_cast<double>(n),
               .reason = "a width is the difference of two rounded edges as large as the channel, N times smaller; "
                         "depths are as uncertain as widths, and a wave of relative height e has the velocity e c"});
  at_rest.from("the same")
      .check(
          "drift", "Edges of the water at rest stay in place to round-off.", "largest displacement of an edge [m]",
          &Results::drift,
          Roundoff{.operations = two_edges,
                   .scale = length,
                   .reason = "these waves, two particles long, move edges by the rounding of two edges of this size"});
}

Results compute(const Run& run) {
  particles::ParticleFlow flow = lake(run);
  const particles::Array edges = flow.particles().edge;
  const double tau = time_step(flow, run);
  const long steps = run.integer("steps");
  const long between = steps < 500 ? 1 : steps / 500;
  Results r;
  for (long k = 0; k < steps; ++k) {
    flow.advance(tau);
    const double fastest = worst(flow.particles().velocity);
    r.velocity.add(fastest, flow.time());
    if (k % between == 0) {
      r.time.push_back(flow.time());
      r.speed.push_back(fastest);
      run.progress(static_cast<double>(k) / static_cast<double>(steps));
    }
  }
  for (std::size_t k = 0; k < edges.size(); ++k) r.drift.add(flow.particles().edge[k] - edges[k], edges[k]);
  r.mass_defect = flow.mass_defect();
  r.momentum_defect = flow.momentum_defect();
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("max_velocity", r.velocity.value());
  exhibit.measure("edge_drift", r.drift.value());
  exhibit.measure("mass_defect", r.mass_defect);
  exhibit.measure("momentum_defect", r.momentum_defect);
  std::vector<double> speed = r.speed;
  for (double& u : speed) {
    if (u < 1e-18) u = 1e-18;  // the axis is logarithmic
  }
  exhibit.figure("velocity", "Largest velocity against time", "The velocity stays at round-off.")
      .panel({.x = "t [s]", .y = "max |u| [m/s]", .log_y = true})
      .line("particles", r.time, speed, Role::computed);
  std::vector<double> x;
  std::vector<double> z;
  std::vector<double> surface;
  const Bed bed = bumps();
  for (int k = 0; k <= 300; ++k) {
    x.push_back(length * k / 300);
    z.push_back(bed.elevation(x.back()));
    surface.push_back(values.real("surface"));
  }
  auto& panel =
      exhibit.figure("lake", "The lake", "Bed and surface.").panel({.x = "x [m]", .y = "elevation [m]", .y_min = -0.1});
  panel.fill("water", x, surface, Role::water);
  panel.fill("bed", x, z, Role::bed);
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
  c.study = Study(claims, compute, show, "well-balanced bed reaction");
  return c;
}

}  // namespace seiche::validation::cases::lake_at_rest_particles
