/*
A particle of the method is a rectangle of constant area whose height is the depth; a row of them approximates the
water, as in the paper's picture of a parabola. When particles move with their velocities, neighbours overlap or
separate; a rearrangement rebuilds one of the two so that they touch again: in an overlap the one of smaller density, at
a gap the faster one. If the rebuilt particle would become the denser of the two, its position changes as well.

Rebuilding one particle of a pair moves only the edge they share. The rule is therefore a choice of a velocity for every
edge, which the scheme of this suite takes, with the thrust, from the Riemann problem of the pair: the order of
processing is irrelevant, and areas and momentum are conserved to all digits.

**What is compared.** The area of the rectangles with the parabola; the areas before and after a rearrangement.

**What to look at.** The third picture of the rearrangement: the edge moves farther than with either velocity, because
the deep particle also exerts a thrust.
*/
#include <cmath>

#include <fmt/format.h>

#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"

namespace seiche::validation::cases::particle_rearrangement {

using evidence::Role;
namespace particles = shallow_water_particles;

/// h = 1 - x^2 on [-1, 1], of the paper's figure 2.
double parabola_depth(double x) {
  return 1 - x * x;
}

/// Of the paper's figures 3 and 4: a fast, deep particle, the second of the row, runs into a slow, shallow one.
particles::Particles row() {
  return particles::uniform_stretches({{0, 2, {1.5, 1.5}}, {2, 4, {0.8, 0}}}, 4);
}

struct Results {
  particles::Particles parabola;
  double area = 0;
  particles::Particles before;
  particles::Particles after = {};
  Worst area_change = {};
};

void draw_channel(evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("channel", "A channel of constant cross-section",
                                "Section along the channel and across it.", {"bzz-fig-1"});
  const std::vector<double> x = evenly(0, 10, 101);
  auto& along = figure.panel({.x = "x [m]", .y = "depth h [m]", .title = "along", .y_min = -0.1, .y_max = 1.5});
  along.fill("water", x, each(x, [](double at) { return 1 + 0.15 * std::sin(0.9 * at); }), Role::water);
  along.line("bed", std::vector<double>{0, 10}, std::vector<double>{0, 0}, Role::bed);
  auto& across = figure.panel({.x = "y [m]", .y = "", .title = "across", .y_min = -0.1, .y_max = 1.5});
  across.fill("water", std::vector<double>{0, 2}, std::vector<double>{1, 1}, Role::water);
  across.line("walls", std::vector<double>{0, 0, 2, 2}, std::vector<double>{1.3, 0, 0, 1.3}, Role::bed);
}

void draw_rearrangement(evidence::Exhibit& exhibit, const Results& r, double tau) {
  auto& figure = exhibit.figure("rearrangement", "Rearrangement of two particles",
                                "Before; moved, each with its velocity, overlapping; rearranged: the shared edge has "
                                "moved, areas are conserved, both centres have changed.",
                                {"bzz-fig-3", "bzz-fig-4"});
  const auto draw = [&](const std::string& title, const particles::Particles& row, double moved) {
    auto& panel = figure.panel(
        {.x = "x [m]", .y = "depth h [m]", .title = title, .x_min = 0.5, .x_max = 4, .y_min = 0, .y_max = 2.2});
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
      const double left = row.edge[i] + moved * row.velocity[i];
      const double right = row.edge[i + 1] + moved * row.velocity[i];
      const double depth = row.depth(i);
      panel.line(i == 1 ? "fast" : "slow", std::vector<double>{left, left, right, right},
                 std::vector<double>{0, depth, depth, 0}, i == 1 ? Role::computed : Role::peer);
    }
  };
  draw("before", r.before, 0);
  draw("moved apart: overlap", r.before, tau);
  draw("rearranged", r.after, 0);
}

void claims(const Values& values, const Claims<Results>& claims) {
  const long n = values.integer("particles");
  const double tau = values.real("time_step");
  claims.at(fmt::format("N = {}", n))
      .from("integral of 1 - x^2 over [-1, 1]")
      .check("area", "The total area of the rectangles equals the area of the parabola to round-off.", "area [m^2]",
             &Results::area,
             evidence::Roundoff{.operations = static_cast<double>(40 * n),
                                .scale = 4.0 / 3,
                                .reason = "a sum over forty quadrature points per particle, of the size of the area",
                                .expected = 4.0 / 3});
  const auto after_step = claims.at(fmt::format("tau = {:g} s", tau));
  const particles::Particles before = row();
  const shallow_water::State star =
      shallow_water::star_state(9.81, {before.depth(1), before.velocity[1]}, {before.depth(2), before.velocity[2]});
  after_step.from("section 3 of the paper")
      .check(
          "rearranged-area", "The area of every particle is conserved exactly in a rearrangement.",
          "largest change of an area [m^2]", &Results::area_change,
          evidence::Roundoff{.operations = 1, .scale = 0, .reason = "masses are never written and hence not rounded"});
  after_step.from("a choice of edge velocity, sections 3 and 4 of the paper")
      .check(
          "edge",
          "The velocity of the shared edge equals the middle velocity of the two particles' Riemann problem to "
          "round-off.",
          "position of the edge [m]", [](const Results& r) { return r.after.edge[2]; },
          evidence::Roundoff{.operations = 30,
                             .scale = before.edge[2],
                             .reason = "some thirty operations of the Riemann problem",
                             .expected = before.edge[2] + tau * star.velocity});
}

Results compute(const Run& run) {
  const auto n = run.count("particles");
  Results r{.parabola = particles::particles_from_profile(particles::equal_width_edges(-1, 1, n), parabola_depth,
                                                          [](double) { return 0.0; }),
            .before = row()};
  for (const double mass : r.parabola.mass) r.area += mass;
  particles::ParticleFlow flow(row(), {.left = particles::Free{}, .right = particles::Free{}}, {},
                               {.level = particles::Level::godunov});
  flow.advance(run.real("time_step"));
  r.after = flow.particles();
  for (std::size_t i = 0; i < r.after.size(); ++i) r.area_change.add(r.after.mass[i] - r.before.mass[i]);
  return r;
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  draw_channel(exhibit);
  auto& panel = add_panel(exhibit, "parabola", "Rectangles approximating a parabola",
                          "Each rectangle has the area of the parabola above it.", {.x = "x [m]", .y = "depth h [m]"},
                          {"bzz-fig-2"});
  panel.steps("particles", r.parabola.edge,
              each(indices(r.parabola.size()), [&](std::size_t i) { return r.parabola.depth(i); }), Role::computed);
  const std::vector<double> x = evenly(-1, 1, 201);
  panel.line("parabola", x, each(x, parabola_depth), Role::exact);
  draw_rearrangement(exhibit, r, values.real("time_step"));
}

void particle_rearrangement(Case& c) {
  c.title = "Particles and their rearrangement";
  c.source = literature::bogomolov + ", figures 1 to 4";
  c.parameters = {
      integer("particles", 10L, {4, 10000}, "rectangles under the parabola"),
      real("time_step", 0.12, "s", {1e-6, 0.2}, "time step of the rearrangement"),
  };
  c.published = {{.tiles = {"bzz-fig-1", "bzz-fig-2", "bzz-fig-3", "bzz-fig-4"}}};
  c.study = Study(claims, compute, show);
}

}  // namespace seiche::validation::cases::particle_rearrangement
