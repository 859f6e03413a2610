// What the particle method keeps for ever: mass, length, momentum minus booked impulses, and a lake at rest.
#include <cmath>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::particles_closed_basin_test {

using namespace shallow_water_particles;

const std::string source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method";

TEST_CASE("mass, length and momentum of a closed basin over 1e5 steps", "[conservation]") {
  Check check("particles_closed_basin", "Closed basin: mass, length and momentum",
              "A dam break 2 | 1 sloshes in a basin of 100 m for 1e5 steps and meets the walls many times. Masses are "
              "never written after the start and the end edges never move, so mass and length keep every bit; momentum "
              "minus the booked impulses of the walls changes by roundings.",
              source);
  ParticleFlow flow(dam_break(0, 50, 100, {2, 0}, {1, 0}, 500));
  long adjacent = 0;  // neighbours that both keep a jump of the same facing
  for (int k = 0; k < 100000; ++k) {
    flow.advance(0.01);
    const auto& jumps = flow.jumps();
    for (std::size_t j = 0; j + 1 < jumps.size(); ++j) {
      if (jumps[j].particle + 1 == jumps[j + 1].particle && jumps[j].facing == jumps[j + 1].facing) ++adjacent;
    }
  }
  check.at("N = 500, tau = 0.01 s, 1e5 steps");
  check.that("mass", "Mass of the closed basin is constant, bitwise.", "mass defect [m^2]", {flow.mass_defect()},
             Roundoff{0, 150, "masses are never written: no operation is rounded"});
  check.that("length", "The length of the closed basin is constant, bitwise.", "length defect [m]",
             {flow.length() - 100}, Roundoff{0, 100, "the edges at the walls move by exact zeros"});
  const double impulse = flow.ledger().left_impulse.value();
  check.that("momentum", "Momentum minus the walls' impulses stays constant.", "momentum defect [m^3/s]",
             {flow.momentum_defect()},
             Roundoff{6 + 1e5 / 500 * std::pow(420 / impulse, 2), impulse,
                      "the books of the two walls, their sum, and what is left of three numbers are rounded once, as "
                      "large as the impulse of a wall, for sums are compensated; and every step rounds the momentum of "
                      "each particle, 420/500 at most"});
  // One bore crosses the basin for ever. Where the water beside it is not uniform, the mean of the next particle
  // differs from the state that the jump is between, and the jump is found in both.
  check.that("adjacent", "No two neighbouring particles keep a jump of the same facing.",
             "pairs of them over all steps", {static_cast<double>(adjacent)}, Bound{0, "the smaller one is dropped"});
  check.that("dropped", "The part of a particle with a dropped event that lies beyond its jump is less than half.",
             "largest part of such a particle beyond the jump", {flow.events().discarded_inside.value()},
             Bound{0.5,
                   "a jump counts if it is twice as large as what the particles beside it differ by: a neighbour's "
                   "mean lies by less than half of it from the state there"});
}

TEST_CASE("a lake over an uneven bed stays at rest", "[conservation]") {
  Check check("particles_lake_at_rest", "Lake at rest over an uneven bed",
              "Surface 0.8 over $z = 0.3 e^{-(x-5)^2} + 0.05 \\sin 3x$. Edge thrusts and bed reaction cancel to "
              "rounding, and no drift builds up over 1e4 steps.",
              "Audusse et al., SIAM J. Sci. Comput. 25 (2004) 2050");
  const double root_pi = std::sqrt(std::acos(-1.0));
  const Bed bed = {[](double x) { return 0.3 * std::exp(-(x - 5) * (x - 5)) + 0.05 * std::sin(3 * x); },
                   [=](double x) { return 0.15 * root_pi * std::erf(x - 5) - 0.05 / 3 * std::cos(3 * x); }};
  const Array edges = equal_width_edges(0, 10, 200);
  const Particles start = particles_from_primitives(
      edges, [&](double x) { return 0.8 * x - bed.primitive(x); }, [](double) { return 0.0; });
  Forcing forcing;
  forcing.bed = bed;
  ParticleFlow flow(start, {}, forcing);
  Worst fastest;
  for (int k = 0; k < 10000; ++k) {
    flow.advance(0.005);
    for (const double u : flow.particles().velocity) fastest.add(u);
  }
  Worst drift;
  for (std::size_t k = 0; k < edges.size(); ++k) drift.add(flow.particles().edge[k] - edges[k]);
  // The mean bed of a particle is a difference of primitives of size 8 over a width of 0.05: 2e-14 of surface, and
  // g times its slope (over the width) times the step is the velocity that starts.
  check.at("N = 200, tau = 0.005 s, 1e4 steps");
  check.that("velocity", "Particle velocities of the lake at rest stay zero to round-off.", "largest speed [m/s]",
             {fastest.value()},
             Roundoff{1e4, 2.8, "one rounded balance of thrusts and bed per step; scale is the celerity"});
  check.that("drift", "Edges of the lake at rest do not drift.", "largest displacement [m]", {drift.value()},
             Roundoff{1e4, 10, "one rounded displacement per step; scale is position"});
  check.from(source).that("momentum", "Momentum equals the booked impulses of ends and bed.", "momentum defect [m^3/s]",
                          {flow.momentum_defect()},
                          Roundoff{1e4, 3.1 * 0.005 * 200,
                                   "one rounded sum of 200 reactions per step; scale is thrust times step times 200"});
}

}  // namespace seiche::verification::particles_closed_basin_test
