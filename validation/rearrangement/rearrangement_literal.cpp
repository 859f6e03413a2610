/*
The rearrangement of Bogomolov, Zakharov and Zerkal as it is written, beside what this suite makes of it. A step is
theirs: every rectangle moves with its velocity; pairs that overlap or part are rebuilt, in an overlap the particle of
smaller density, at a gap the faster one; from the new depths follow pressures, from these new velocities. Figure 4
adds: if the rebuilt particle would become denser than the one that rebuilt it, its position changes as well; that is,
it gets the other's density, and its far side moves, until all pairs touch.

The text leaves the pressure at the shared side open ("the pressure scheme of [4]"): here that of the particle that was
rebuilt. Densities that differ by less than 1e-9 of themselves are equal and sides nearer than 1e-11 of the row touch:
told apart by the last bit, a sweep over the pairs would go back and forth and not end.

**Set-up.** Their bore, 2 m over 1 m, 120 particles of 1 m, $\tau$ = 0.08 s, 100 steps (figure 12). And the bore 1 m
over 0.63 m that starts 5 m from a wall 10 m away, with ten particles and $\tau$ = 0.02 s (figure 24).

**What is compared.** The front of the bore with the exact one, how many particles it takes, the depth behind it and
ahead of it; the same of today's hand-over, where edge velocity and pressure come from one Riemann problem. And the
depth at the wall after the reflection, for which the paper prints 1.36 m.

**What to look at.** The method works as it is written: the bore is one particle wide, and in its place. The depth
behind it is not even, for a velocity of one side with a pressure of one particle is no solution of the jump's
equations; at the wall it wanders, and 1.36 m is one of its values. The hand-over leaves both exact.
*/
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/models/shallow_water_particles/as_written.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases::rearrangement_literal {
namespace {

using evidence::Role;
namespace particles = shallow_water_particles;

constexpr double gravity = 9.81;
constexpr double behind = 2, ahead = 1, place = 40, length = 120, tau = 0.08;
constexpr long steps = 100;
constexpr std::size_t count = 120;
constexpr double printed = 1.36;  ///< wall depth of figure 24 [m]

struct Outcome {
  double front = 0;       ///< of the jump, by the depth of the particle that holds it [m]
  double transition = 0;  ///< particles whose depth is neither side's, to a twentieth of the jump
  double uneven = 0;      ///< largest difference of the depth from that behind the jump
  double ahead = 0;       ///< and from that ahead of it
  std::vector<double> edges, depth;
};

Outcome read(std::vector<double> edges, std::vector<double> depth) {
  Outcome outcome;
  const auto is_behind = [](double h) { return h > behind - 0.05 * (behind - ahead); };
  std::size_t holds = count - 1;  // the first particle that is not as deep as the water behind
  while (holds > 0 && !is_behind(depth[holds - 1])) --holds;
  outcome.front = edges[holds] + (depth[holds] - ahead) / (behind - ahead) * (edges[holds + 1] - edges[holds]);
  Count between;
  for (const double h : depth) {
    between.add(h, [&](double one) { return !is_behind(one) && one > ahead + 0.05 * (behind - ahead); });
  }
  outcome.transition = between.value();
  Worst uneven, disturbed;
  for (std::size_t i = 0; i < count; ++i) {
    // Not the particle of the jump, nor its neighbours.
    if (edges[i + 1] < outcome.front - 2) uneven.add(depth[i] - behind);
    if (edges[i] > outcome.front + 2) disturbed.add(depth[i] - ahead);
  }
  outcome.uneven = uneven.value();
  outcome.ahead = disturbed.value();
  outcome.edges = std::move(edges);
  outcome.depth = std::move(depth);
  return outcome;
}

struct Results {
  Outcome literal, hand_over;
  std::vector<double> time, wall;  ///< of the reflection
  double lowest = 0, highest = 0;  ///< depth at the wall from step 90 on, when the bore has left it
};

Results compute(const Run& /*run*/) {
  Results r;
  const particles::Particles start = particles::bore(gravity, 0, place, length, behind, ahead, count);
  const particles::Ends ends{particles::Piston{[u = start.velocity[0]](double) { return u; }}, particles::Wall{}};
  particles::AsWritten literal(start, ends, gravity);
  particles::ParticleFlow flow(start, ends);
  for (long k = 0; k < steps; ++k) {
    literal.advance(tau);
    flow.advance(tau);
  }
  std::vector<double> of_literal, of_flow;
  for (std::size_t i = 0; i < count; ++i) {
    of_literal.push_back(literal.depth(i));
    of_flow.push_back(flow.particles().depth(i));
  }
  r.literal = read(literal.edges(), std::move(of_literal));
  r.hand_over = read({flow.particles().edge.begin(), flow.particles().edge.end()}, std::move(of_flow));

  const particles::Particles ten = particles::bore(gravity, 0, 5, 10, 1, 0.63, 10);
  particles::AsWritten reflected(
      ten, {particles::Piston{[u = ten.velocity[0]](double) { return u; }}, particles::Wall{}}, gravity);
  Smallest lowest;
  Largest highest;
  for (int k = 1; k <= 160; ++k) {
    reflected.advance(0.02);
    r.time.push_back(reflected.time());
    r.wall.push_back(reflected.depth(9));
    if (k < 90) continue;
    lowest.add(r.wall.back());
    highest.add(r.wall.back());
  }
  r.lowest = lowest.value();
  r.highest = highest.value();
  return r;
}

void claims(const Values& /*values*/, const Claims<Results>& claims) {
  const std::string source =
      "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, section 3, figures 4 "
      "and 12";
  const auto here = claims.at("N = 120, tau = 0.08 s");
  const double exact = place + exact::Bore(gravity, ahead, behind, 0, place).speed() * tau * steps;
  here.check(
      {.id = "front",
       .text = "By the rules as written the bore is where it should be, to one particle.",
       .quantity = "place of the front after 100 steps",
       .unit = "m",
       .source = source},
      [](const Results& r) { return r.literal.front; },
      evidence::Bound{.limit = 1, .reason = "a particle, in which the method holds a jump", .expected = exact});
  here.check(
      {.id = "width",
       .text = "The bore is one particle wide.",
       .quantity = "particles with a depth between both sides'",
       .source = source},
      [](const Results& r) { return r.literal.transition; },
      evidence::Bound{.limit = 0, .reason = "the paper's figure 12 shows one", .expected = 1});
  here.check(
      {.id = "behind",
       .text = "Behind the bore the depth is even to two per cent.",
       .quantity = "largest difference of a depth from 2 m",
       .unit = "m",
       .source = source},
      [](const Results& r) { return r.literal.uneven; },
      evidence::Bound{.limit = 0.04,
                      .reason = "what the text leaves open (order of the pairs, ties, the ends) changes the depth "
                                "by as much"});
  here.check(
      {.id = "ahead",
       .text = "Ahead of the bore the water is still.",
       .quantity = "largest difference of a depth from 1 m",
       .unit = "m",
       .source = source},
      [](const Results& r) { return r.literal.ahead; },
      evidence::Bound{.limit = 1e-9 * count * steps,
                      .reason = "densities that differ by 1e-9 are equal, for each pair in each step"});
  here.check(
      {.id = "hand-over-front",
       .text = "With the hand-over the front is exact.",
       .quantity = "place of the front after 100 steps",
       .unit = "m",
       .source = source},
      [](const Results& r) { return r.hand_over.front; },
      evidence::Roundoff{.operations = 100.0 * steps,
                         .scale = length,
                         .reason = "the jump is exact: a hundred rounded operations per particle and step",
                         .expected = exact});
  here.check(
      {.id = "hand-over-behind",
       .text = "The depth behind the front is exact with the hand-over.",
       .quantity = "largest difference of a depth from 2 m",
       .unit = "m",
       .source = source},
      [](const Results& r) { return r.hand_over.uneven; },
      evidence::Roundoff{.operations = 100.0 * steps, .scale = behind, .reason = "the same"});
  const auto wall = claims.at("N = 10, tau = 0.02 s");
  const std::string at_wall = "Bogomolov, Zakharov and Zerkal, figure 24";
  wall.check(
      {.id = "wall-lowest",
       .text = "After the reflection the depth at the wall falls to the printed 1.36 m,",
       .quantity = "smallest depth at the wall less 1.36 m",
       .unit = "m",
       .source = at_wall},
      [](const Results& r) { return std::max(r.lowest - printed, 0.0); },
      evidence::Bound{.limit = 0.005, .reason = "half a unit of the printed digits"});
  wall.check(
      {.id = "wall-highest",
       .text = "and rises to it: the printed number is a value of the method.",
       .quantity = "1.36 m less the largest depth at the wall",
       .unit = "m",
       .source = at_wall},
      [](const Results& r) { return std::max(printed - r.highest, 0.0); },
      evidence::Bound{.limit = 0.005, .reason = "half a unit of the printed digits"});
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("rows", "The bore by the rules as they are written, and by the hand-over",
                                "Rectangles after 100 steps.");
  const double front = place + exact::Bore(gravity, ahead, behind, 0, place).speed() * tau * steps;
  const auto draw = [&](const std::string& name, const Outcome& outcome) {
    auto& panel = figure.panel(
        {.x = "x [m]", .y = "depth h [m]", .title = name, .x_min = 30, .x_max = 95, .y_min = 0, .y_max = 4});
    panel.steps("particles", outcome.edges, outcome.depth, Role::computed);
    panel.line("exact", std::vector<double>{0, front, front, length}, std::vector<double>{behind, behind, ahead, ahead},
               Role::exact);
  };
  draw("as written", r.literal);
  draw("hand-over", r.hand_over);
  auto& wall = exhibit.figure("wall", "Depth at the wall by the rules as they are written", "Ten particles.")
                   .panel({.x = "t [s]", .y = "depth h [m]"});
  wall.line("as written", r.time, r.wall, Role::computed);
  wall.line("printed", std::vector<double>{r.time.front(), r.time.back()}, std::vector<double>{printed, printed},
            Role::data);
}

}  // namespace

Case rearrangement_literal() {
  Case c;
  c.title = "The rearrangement of particles as it is written";
  c.source =
      "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, figures 3, 4, 12 and "
      "24";
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases::rearrangement_literal
