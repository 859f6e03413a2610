/*
Two bores, 2 m and 1.5 m deep, run towards each other through still water of 1 m. They meet at $t_c = 4.118$ s and pass:
after the meeting two weaker jumps enclose water 2.697 m deep, the middle state of the Riemann problem of the two states
behind the bores.

Both ends are pistons.

**What is compared.** The profile 2 s after the meeting, for several numbers of particles and the three levels of the
method.

**What to look at.** The collision is the one event in which two jumps share a particle. A method that falls back to
smeared jumps there leaves a scar at the place of the meeting that decays only as $1/N$; here the particle keeps both
jumps, and then both that leave it.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/colliding_bores.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;

void run(Running& run) {
  const double gravity = run.real("gravity");
  const exact::CollidingBores bores(gravity, run.real("left_depth"), run.real("still_depth"), run.real("right_depth"),
                                    30, 70);
  using End = FlowProblem::End;
  const FlowProblem problem = problem_of(bores, gravity, 0, 100, {30, 70}, End::stream, End::stream);
  const double time = bores.collision_time() + run.real("after");
  run.record.measure("collision_time", bores.collision_time());
  run.record.measure("collision_place", bores.collision_place());
  run.record.measure("star_depth", bores.star().depth);
  run.record.measure("star_velocity", bores.star().velocity);

  const long n = run.integer("particles");
  const Discretisation finest{.scheme = "H2", .particles = 4 * n, .theta = 1.5};
  const auto flow = run_and_draw(run.record, problem, finest, {0.7 * bores.collision_time(), time}, "Two bores meet",
                                 {}, [&](double done) { run.progress(0.5 * done); });
  claim_conservation(run.record, *flow);

  evidence::Table table{
      .id = "levels",
      .title = "Error of the levels",
      .caption = "Cell L1(h) after the collision.",
      .columns = {{"particles", ""}, {"G1", "m"}, {"M2", "m"}, {"H2", "m"}, {"H2 reconstructed", "m"}}};
  auto& panel =
      run.record.figure("convergence", "Error against the number of particles", "Cell L1(h) 2 s after the meeting.")
          .panel({.x = "particles", .y = "cell L1(h) [m]", .log_x = true, .log_y = true});
  std::vector<double> counts;
  std::vector<std::vector<double>> errors(3);
  double reconstructed = 0;
  for (const long particles : {n, 2 * n, 4 * n}) {
    counts.push_back(static_cast<double>(particles));
    for (std::size_t level = 0; level < 3; ++level) {
      const Contestant c =
          contest(problem, {.scheme = particle_schemes[level], .particles = particles, .theta = 1.5}, time, nullptr);
      errors[level].push_back(c.errors.cell.depth.l1);
      if (level == 2) reconstructed = c.errors.reconstructed.depth.l1;
    }
    table.rows.push_back({counts.back(), errors[0].back(), errors[1].back(), errors[2].back(), reconstructed});
  }
  for (std::size_t level = 0; level < 3; ++level)
    panel.points(particle_schemes[level], counts, errors[level], Role::computed);
  run.record.table(std::move(table));
  run.record.measure("reconstructed_l1_h", reconstructed);
  run.record.measure("cell_l1_h", errors[2].back());
  run.record.check(
      {.id = "reconstructed_l1_h",
       .text = "The profile after the collision is the exact one.",
       .quantity = "reconstructed L1(h)",
       .unit = "m",
       .source = "Riemann problem of the states behind the bores"},
      {.value = reconstructed, .resolution = finest.text()},
      evidence::Bound{.limit = 1e-10,
                      .reason = "both jumps are followed through the particle they share; what is left is round-off "
                                "of the instants at which they enter and leave it"});
}

}  // namespace

Case colliding_bores() {
  Case c;
  c.title = "Two bores collide";
  c.source =
      "J. J. Stoker, Water Waves, 1957, 10.7; E. F. Toro, Shock-capturing methods for free-surface shallow flows, 2001";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("particles", {50, 400, 1600}, {20, 1e6},
              "smallest number of particles; twice and four times as many run too"),
      real("left_depth", 2.0, "m", {1e-3, 1e3}, "depth behind the left bore"),
      real("still_depth", 1.0, "m", {1e-3, 1e3}, "depth of the still water between"),
      real("right_depth", 1.5, "m", {1e-3, 1e3}, "depth behind the right bore"),
      real("after", 2.0, "s", {0.01, 10}, "time after the meeting"),
      real("gravity", 9.81, "m/s^2", {1e-3, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
