/*
A piston starts gently, $u = u_p \sin^2(\pi t/4)$ for 2 s and $u_p = 1.5$ m/s from then on, into still water 1 m deep.
Its compression wave steepens until the characteristics cross, and a bore forms inside smooth flow: nothing tells the
scheme where or when.

**What is compared.** The position of the bore at $t = 10$ s with the finest run; its width; the depth at the piston,
which starts at that of a simple wave and must settle to that behind a bore.

**What to look at.** Level `H2` takes the jump into one particle as soon as it stands out against its surroundings.
*/
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/models/shallow_water_particles/initial.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/shallow_water/relations.hpp"
#include "validation/case/case.hpp"
#include "validation/studies/shallow_water/flow_evidence.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
namespace particles = shallow_water_particles;

constexpr double length = 60;

Profile profile_at(double time, double gravity, double depth, double speed, long n) {
  const auto piston = [speed](double t) {
    return t < 2 ? speed * std::pow(std::sin(std::numbers::pi * t / 4), 2) : speed;
  };
  particles::ParticleFlow flow(particles::uniform_stretches({{0, length, {depth, 0}}}, static_cast<std::size_t>(n)),
                               {.left = particles::Piston{piston}, .right = particles::Wall{}}, {.gravity = gravity},
                               {.theta = 1.5});
  flow.advance_to(time);
  return flow.measured_profile();
}

/// Depth of a bore in which still water of the given depth takes up the velocity at once, by bisection.
double bore_depth(double gravity, double depth, double speed) {
  double low = depth;
  double high = 100 * depth;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (shallow_water::velocity_change(gravity, middle, depth) < speed ? low : high) = middle;
  }
  return low;
}

void run(Running& run) {
  const double gravity = run.real("gravity");
  const double speed = run.real("piston_velocity");
  const double depth = 1;
  const double time = 10;
  const long n = run.integer("particles");
  const double bore = bore_depth(gravity, depth, speed);
  const double simple = std::pow(shallow_water::celerity(gravity, depth) + 0.5 * speed, 2) / gravity;

  std::vector<double> sizes;
  std::vector<double> positions;
  Profile finest;
  const Front near{.behind = bore, .ahead = depth, .position = 0.5 * length, .reach = 0.5 * length};
  for (const long count : {n, 2 * n, 4 * n, 8 * n}) {
    finest = profile_at(time, gravity, depth, speed, count);
    sizes.push_back(length / static_cast<double>(count));
    positions.push_back(front_position(finest, near));
    run.progress(static_cast<double>(count) / static_cast<double>(15 * n));
  }
  const evidence::GridConvergence study = evidence::grid_convergence(sizes, positions, 1);
  const double at_piston = finest.means.front().depth;
  const Front front{.behind = bore, .ahead = depth, .position = positions.back(), .reach = 5};
  const long width = front_width(finest, front);
  run.record.measure("front_position", positions.back());
  run.record.measure("front_position_extrapolated", study.extrapolated);
  run.record.measure("front_uncertainty", study.uncertainty);
  run.record.measure("front_width", static_cast<double>(width));
  run.record.measure("piston_depth", at_piston);
  run.record.measure("piston_depth_bore", bore);
  run.record.measure("piston_depth_simple_wave", simple);
  run.record.measure("largest_depth", std::max_element(finest.means.begin(), finest.means.end(), [](State a, State b) {
                                        return a.depth < b.depth;
                                      })->depth);
  const std::string resolution = fmt::format("N = {}", 8 * n);
  if (run.real("gravity") == 9.81 && speed == 1.5) {
    run.record.check({.id = "front",
                      .text = "The bore is where a very fine run has it.",
                      .quantity = "position of the bore",
                      .unit = "m",
                      .source = "independent implementation with 6400 particles"},
                     {.value = positions.back(), .uncertainty = study.uncertainty, .resolution = resolution},
                     evidence::Uncertainty{
                         .expected = 39.094,
                         .data = 0.005,
                         .useful = 0.06,
                         .reason = "half a cell width of the fine run (60 m/6400) and the grid convergence here; a "
                                   "tenth of a percent of the way decides"});
  }
  run.record.check(
      {.id = "width",
       .text = "The bore that has formed lies inside a single particle.",
       .quantity = "particles between 5 % and 95 % of the jump",
       .source = "the hand-over of the method"},
      {.value = static_cast<double>(width), .resolution = resolution},
      evidence::Bound{.limit = 1, .reason = "one particle holds the jump; none at the instant of hand-over"});
  run.record.check(
      {.id = "plateau",
       .text = "The depth at the piston settles to that behind a bore.",
       .quantity = "depth at the piston",
       .unit = "m",
       .source = "shock relations and Riemann invariants"},
      {.value = at_piston, .resolution = resolution},
      evidence::Bound{.limit = simple - bore,
                      .reason = "it starts at the depth of a simple wave; what the forming bore reflects to the piston "
                                "brings it to that of a bore and never exceeds the first difference",
                      .expected = bore});
  const Means means = means_of(finest);
  auto& panel =
      run.record.figure("profile", "A bore forms inside a compression wave", fmt::format("Depth at t = {:g} s.", time))
          .panel({.x = "x [m]", .y = "depth h [m]"});
  panel.steps(fmt::format("{} particles", 8 * n), finest.edges, means.depth, Role::computed);
}

}  // namespace

Case shock_formation() {
  Case c;
  c.title = "A bore forms ahead of a piston";
  c.source = "J. J. Stoker, Water Waves, 1957, 10.6";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      integer("particles", {50, 200, 800}, {20, 1e5}, "coarsest number of particles; 2, 4 and 8 times as many run too"),
      real("piston_velocity", 1.5, "m/s", {0.1, 10}, "final velocity of the piston"),
      real("gravity", 9.81, "m/s^2", {0.1, 1e3}, "acceleration of gravity"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
