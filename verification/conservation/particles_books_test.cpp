// What the particle method keeps for ever: mass, length, momentum minus booked impulses, a lake at rest and a steady
// flow that passes fixed sections; and long rows, which a step goes through stretch by stretch, on threads.
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/steady_flow.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/error_measures.hpp"
#include "verification/check.hpp"
#include "verification/conservation/differences.hpp"
#include "verification/conservation/long_rows.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::particles_books_test {

using namespace shallow_water_particles;

const std::string source = "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method";

TEST_CASE("mass, length and momentum of a closed basin over 1e5 steps", "[conservation]") {
  Check check("particles_closed_basin", "Closed basin: mass, length and momentum",
              "A dam break 2 | 1 sloshes in a basin of 100 m for 1e5 steps and meets the walls many times. Masses are "
              "never written after the start and the end edges never move, so mass and length are bitwise constant; "
              "momentum minus the booked impulses of the walls changes by roundings.",
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
  check.that("mass", "Mass of the closed basin is constant, bitwise.", "mass error [m^2]", {flow.mass_defect()},
             Roundoff{0, 150, "masses are never written: no operation is rounded"});
  check.that("length", "The length of the closed basin is constant, bitwise.", "length error [m]",
             {flow.particles().edge.back() - flow.particles().edge.front() - 100},
             Roundoff{0, 100, "the edges at the walls move by exact zeros"});
  const double impulse = flow.ledger().left_impulse.value();
  check.that("momentum", "Momentum minus the impulses of the walls is constant to round-off.", "momentum error [m^3/s]",
             {flow.momentum_defect()},
             Roundoff{6 + 1e5 / 500 * std::pow(420 / impulse, 2), impulse,
                      "the recorded impulses of the two walls, their sum, and the difference of three numbers are "
                      "rounded once at the size of a wall's impulse, because sums are compensated; and every step "
                      "rounds the momentum of each particle, 420/500 at most"});
  // One bore crosses the basin for ever. Where the water beside it is not uniform, the mean of the next particle
  // differs from the state that the jump is between, and the jump is found in both.
  check.that("adjacent", "The number of neighbouring particles with jumps of the same direction is zero.",
             "pairs of them over all steps", {static_cast<double>(adjacent)}, Bound{0, "the smaller one is dropped"});
  check.that("dropped", "The part of a particle with a dropped event that lies beyond its jump is less than half.",
             "largest part of such a particle beyond the jump", {flow.events().discarded_inside.value()},
             Bound{0.5,
                   "a discontinuity counts if it is twice as large as the difference of the particles beside it: a "
                   "neighbour's mean lies by less than half of it from the state there"});
}

TEST_CASE("every force on the water is recorded in the ledger", "[conservation]") {
  Check check("particles_all_books", "Momentum under all forces",
              "A dam break between walls over a wavy bed, with friction and a body force: momentum is the sum of the "
              "impulses of the two walls, the bed, friction and the body force.",
              source);
  const Bed wavy{[](double x) { return 0.1 * std::cos(x); }, [](double x) { return 0.1 * std::sin(x); }};
  const auto pull = [](double x, double t) { return 0.5 + 0.3 * std::sin(x + t); };
  ParticleFlow flow(dam_break(0, 4, 10, {2, 0}, {1, 0}, 100), {}, {.bed = wavy, .manning = 0.05, .body_force = pull});
  constexpr int count = 200;
  for (int k = 0; k < count; ++k) flow.advance(0.004);
  const Ledger& ledger = flow.ledger();
  Smallest least;
  for (const CompensatedSum& one : {ledger.left_impulse, ledger.right_impulse, ledger.bed_impulse,
                                    ledger.friction_impulse, ledger.source_impulse}) {
    least.add(std::abs(one.value()));
  }
  check.holds("Momentum minus the booked impulses is constant to round-off.", {flow.momentum_defect()},
              Roundoff{5.0 * count * 100, 0.2, "five rounded impulses of at most 0.2 per particle and step"});
  check.holds("Each of the five impulses contributes.", {least.value() > 0.01 ? 1.0 : 0.0},
              Qualitative{"each above 0.01 m^3/s", "zero could be recorded with any sign"});
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
  Particles start;
  start.edge = edges;
  start.velocity.assign(200, 0.0);
  for (std::size_t i = 0; i < 200; ++i) {
    const double raised = bed.primitive(edges[i + 1]) - bed.primitive(edges[i]);
    start.mass.push_back(0.8 * (edges[i + 1] - edges[i]) - raised);
  }
  ParticleFlow flow(start, {}, {.bed = bed});
  Worst fastest;
  for (int k = 0; k < 10000; ++k) {
    flow.advance(0.005);
    fastest.add(worst(flow.particles().velocity));
  }
  // The mean bed of a particle is a difference of primitives of size 8 over a width of 0.05: 2e-14 of surface, and
  // g times its slope (over the width) times the step is the velocity that starts.
  check.at("N = 200, tau = 0.005 s, 1e4 steps");
  check.that("velocity", "Particle velocities of the lake at rest are zero to round-off.", "largest speed [m/s]",
             {fastest.value()},
             Roundoff{1e4, 2.8, "one rounded balance of thrusts and bed per step; scale is the celerity"});
  check.that("drift", "The displacement of particle edges of the lake at rest is zero to round-off.",
             "largest displacement [m]", {largest_difference(flow.particles().edge, edges)},
             Roundoff{1e4, 10, "one rounded displacement per step; scale is position"});
  check.from(source).that("momentum", "Momentum equals the booked impulses of ends and bed.", "momentum error [m^3/s]",
                          {flow.momentum_defect()},
                          Roundoff{1e4, 3.1 * 0.005 * 200,
                                   "one rounded sum of 200 reactions per step; scale is thrust times step times 200"});
}

TEST_CASE("steady subcritical flow over a bump between open sections", "[conservation]") {
  Check check("particles_steady_bump", "Steady flow over a bump between open sections",
              "Particles enter at x = 0 with a given discharge, cross the bump and leave at x = 25 against a given "
              "depth: no particle stays, yet the exact steady flow must stay. Mass and momentum that pass the sections "
              "are booked, and the error of the depth after 40 s falls with the square of the particle width.",
              "Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269");
  const exact::SteadyBump exact(9.81, 4.42, 2);
  const auto error_of = [&](double width) {
    const std::size_t count = cells_of(25, width);
    const Particles start = particles_from_profile(
        equal_width_edges(0, 25, count), [&](double x) { return exact.at(x).depth; },
        [&](double x) { return exact.at(x).velocity; });
    const Open inflow{.discharge = [](double) { return 4.42; }}, outflow{.depth = [](double) { return 2.0; }};
    ParticleFlow flow(start, {inflow, outflow}, {.bed = exact.bed()});
    march(flow, 40);
    const auto error = cell_error(
        flow.measured_profile(), [&](double x) { return exact.at(x); }, exact.breakpoints());
    check.holds(fmt::format("mass_{}", count) + ": Mass equals the inflow through the sections.", {flow.mass_defect()},
                Roundoff{6, flow.ledger().left_mass.value(),
                         "the recorded inflows of the two sections, their sum, and the difference of three numbers are "
                         "rounded once at the size of the mass that has entered; sums are compensated, and one "
                         "particle at a section, of 1/80 of that mass at most, is rounded per step"});
    check.holds(fmt::format("momentum_{}", count) + ": Momentum equals the booked impulses.", {flow.momentum_defect()},
                Roundoff{6 + static_cast<double>(flow.steps()) / static_cast<double>(count) *
                                 std::pow(flow.momentum() / flow.ledger().left_impulse.value(), 2),
                         flow.ledger().left_impulse.value(),
                         "the recorded impulses of the sections and of the bed, their sum, and the difference of three "
                         "numbers are rounded once at the size of a section's impulse, because sums are compensated; "
                         "and every step rounds the momentum of each particle"});
    return error.depth.l1;
  };
  refine(check, {"particle width [m]", widths(25, {25, 50, 100, 200})},
         {{"order",
           "The depth over the bump converges at second order.",
           {2, 0.5,
            "the ends of the bump have a kink in z', where the limited slopes are first-order accurate over a region "
            "that shrinks with the width"}}},
         error_of);
}

constexpr long steps = 6;  // of rows and pieces of them

/// Of the particles that no end of the piece has reached, and of the limits of their steps.
double differing(Level level) {
  constexpr std::size_t begin = 1500, count = 1500, out_of_reach = 3 * steps;
  ParticleFlow longer(ripples(0, 5000), {}, {}, {.level = level});
  ParticleFlow piece(ripples(begin, begin + count), {}, {}, {.level = level});
  const double tau = 0.5 * longer.largest_step().tau;
  for (long k = 0; k < steps; ++k) {
    longer.advance(tau);
    piece.advance(tau);
  }
  const auto apart = [&](const Array& of_longer, const Array& of_piece) {
    return largest_difference(std::span(of_longer).subspan(begin + out_of_reach, count - 2 * out_of_reach),
                              std::span(of_piece).subspan(out_of_reach));
  };
  return worst(std::array{apart(longer.particles().edge, piece.particles().edge),
                          apart(longer.particles().velocity, piece.particles().velocity)});
}

TEST_CASE("results of a row of shallow-water particles do not depend on its division into stretches",
          "[conservation]") {
  Check check("particles_stretches", "Shallow-water particles: stretch by stretch",
              "A row of 5000 particles, which a step goes through in three stretches, and a piece of it across a seam: "
              "where the ends of the piece have not been felt, edges and velocities are equal but for the round-off of "
              "edges whose waves are solved for to the end in one row and to 1e-13 in the other. Every particle has a "
              "part in the limit of the next step.");
  for (const auto& [level, name] :
       {std::pair{Level::godunov, "G1"}, std::pair{Level::muscl, "M2"}, std::pair{Level::hand_over, "H2"}}) {
    check.holds(std::string(name) + ": A piece of the row moves like the whole.", {differing(level)},
                Bound{1e-11, "waves to 1e-13, positions up to 3000 m to 5e-13, six steps"});
  }
  // The narrowest particle is the last of a stretch.
  Particles row = ripples(0, 5000);
  constexpr std::size_t narrowest = 2047;
  constexpr double width = 0.25;
  row.edge[narrowest] = row.edge[narrowest + 1] - width;
  row.mass[narrowest] = 1.5 * width;
  row.mass[narrowest - 1] = 1.5 * (2 - width);
  row.velocity.assign(row.size(), 0.0);
  ParticleFlow still(row);
  still.advance(0.1 * still.largest_step().tau);
  check.holds("The last particle of a stretch limits the step when it is the narrowest.",
              {static_cast<double>(still.largest_step().particle)}, Bound{0, "a number of a particle", narrowest});
}

}  // namespace seiche::verification::particles_books_test
