/*
Which model should one take? A round drop without gravity is stretched and drifts, by six models: free particles under
Gauss's principle, the Lagrangian mesh, Dirichlet cells, particles of variable mass, overlapping particles, and weakly
compressible SPH. Dirichlet's ellipse tells how far off each is.

**Set-up.** Radius, density and strain rate are 1: $u = 0.3 + x$, $v = 0.2 - y$ at the beginning. The drift changes
nothing of the motion, but the drop has a momentum to be kept, and leaves the lattice that free particles begin on. Each
model has its usual arrangement: rings of free particles with markers on the rim, a square mesh made round, rings of
Dirichlet cells, staggered rows, a square lattice for SPH. Cells have a hundredth of stabilisation; nodes inside of
variable mass go to the middle of their cells, those of the outline are particles. Steps are a fifth of the spacing,
those of SPH its own. Each is refined in space and time together.

**What is compared.** Places of the rim (markers, nodes of the outline, particles that began within a spacing of it)
with the exact ones at t = 1, when the drop is five times as long as wide; the processor time until then; what energy
and momentum changed by. Then each goes on to t = 3, unless it breaks down or its rim is off by the thin half of the
drop at that time.

**What to look at.** The fields are linear, and the space of the free particles holds them: they are nearer than all
others by a factor of a hundred, and last. The mesh errs to first order along its outline, but takes least time and
lasts. Cells come nearer than the mesh where they last; they end when a node of the outline reaches another, or when a
cell inside has given all its water away, and finer ones do not last longer. Overlapping particles are off by a
spacing, or nearly so, at a hundred times the cost of the mesh. SPH lasts, at ten times the cost of the free particles
and with a hundred times their error. All keep the momentum; cells and SPH change the energy, the others do not.

**When it is no test.** Linear fields flatter the free particles, and no model has walls or gravity here. The discrete
dispersive shallow water has no drop: its water stands on a bottom.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/drop/drop_contenders.hpp"

namespace seiche::validation::cases::drop_models {
namespace {

using exact::StretchingDrop;

const std::string source = "Dirichlet (1860); Frank, Discrete models of incompressible fluid (1994)";

const std::array<Named, 6> names{{{"particles", "free particles"},
                                  {"mesh", "the Lagrangian mesh"},
                                  {"dirichlet", "Dirichlet cells"},
                                  {"variable-mass", "variable mass"},
                                  {"overlapping", "overlapping particles"},
                                  {"sph", "SPH"}}};

StretchingDrop the_drop() {
  return {1, 1, 1};
}

Trial trial_of(const Values& values) {
  const double last = values.real("last");
  return {.end = values.real("time"),
          .last = last,
          .looks = 12,
          .useless = the_drop().other_axis(last),
          .useless_in_words = "the surface is off by the thin half of the drop",
          .energy_scale = std::numbers::pi / 4,
          .momentum_scale = std::numbers::pi * std::numbers::sqrt2 / 2};
}

struct Results {
  Contest contest;
};

/// Steps of the finest resolution until errors are compared.
double steps_of(const Values& values, const std::string& id) {
  const double spacings = 5 * values.real("time");
  if (id == "particles") return spacings * static_cast<double>(values.integer("rings"));
  if (id == "mesh") return spacings * static_cast<double>(values.integer("mesh")) / 2;
  if (id == "overlapping") return spacings * static_cast<double>(values.integer("overlapping"));
  if (id == "sph") return values.real("time") * 14 / (0.3 * 2) * static_cast<double>(values.integer("sph"));
  return spacings * static_cast<double>(values.integer("cells"));
}

void claim_kept(const Claims<Contest>& all, const Values& values) {
  const double drift = 2 * (drop_drift.x * drop_drift.x + drop_drift.y * drop_drift.y);
  for (const Named& model : {names[0], names[1], names[4]}) {
    claim_energy(claims_of(all, model.id), model, 40 * steps_of(values, model.id), 1 + drift,
                 "in every step the reactions of a particle's or a node's neighbours, forty at most, are rounded; "
                 "scale: the kinetic energy with that of the drift, over that of the stretching",
                 "Frank (1994), chapters 1 and 6");
  }
  for (const Named& model : names) {
    claims_of(all, model.id)
        .from("Frank (1994), chapter 1; forces of pairs are opposite")
        .check(
            model.id + "-momentum", fmt::format("The momentum of {} is conserved to round-off.", model.name),
            "change over the sum of all momenta", [](const Entry& entry) { return entry.finest().momentum; },
            Roundoff{.operations = steps_of(values, model.id),
                     .scale = 1,
                     .reason = "the sum of all momenta is rounded once in each step"});
  }
  for (const Named& model : {names[2], names[3]}) {
    claim_dissipates(claims_of(all, model.id), model,
                     "in each step the stabilisation takes a square of differences of the multipliers", source);
  }
  claims_of(all, "sph")
      .from("Monaghan (1994)")
      .check("sph-energy", "The energy of SPH, the energy of compression included, is nearly conserved.",
             "change over the energy of the stretching", energy_of_finest,
             Bound{.limit = 1.0 / (6 * 14 * 14),
                   .reason = "the energy of the compression at the beginning, 1/(6 c^2): what steps change must be "
                             "less than what they resolve"});
}

void claim_accuracy(const Claims<Contest>& all, const Values& values) {
  claims_of(all, "particles")
      .check(
          "particles-rim", "The drop outline of the free particles agrees with the exact ellipse.",
          "rms distance from the exact places [radius]", error_of_finest,
          Bound{.limit = 0.01 / static_cast<double>(values.integer("rings")),
                .reason =
                    "a hundredth of the spacing of the rings, below which particles do not tell where a surface is"});
  claims_of(all, "mesh")
      .check(
          "mesh-order", "The outline of the mesh converges with the first order.",
          "order of the rms distance from the exact places", [](const Entry& entry) { return entry.order(); },
          Order{.theory = 1,
                .tolerance = 0.25,
                .reason = "nodes of the outline slip along it to first order; the meshes begin with cells of a quarter "
                          "of the radius, where terms of other orders are as much of the error"});
  for (const Named& model : {names[2], names[3], names[5]}) {
    claims_of(all, model.id)
        .check(
            model.id + "-rim", fmt::format("The rim of {} is off by less than a spacing.", model.name),
            "rms distance from the exact places over the spacing",
            [](const Entry& entry) { return entry.finest().error / entry.finest().size; },
            Bound{.limit = 1, .reason = "a surface is not known by less than the spacing"});
  }
  claims_of(all, "overlapping")
      .at(fmt::format("{} spacings to the radius", values.integer("overlapping") / 2))
      .check(
          "overlapping-rim",
          "The drop outline of overlapping particles, at half as many rows, is within one particle spacing of the "
          "exact ellipse.",
          "rms distance from the exact places over the spacing",
          [](const Entry& entry) { return entry.attempts.at(1).error / entry.attempts.at(1).size; },
          Bound{.limit = 1,
                .reason = "a surface is not known by less than the spacing; on finer rows noise of single particles is "
                          "in it, which nobody can foretell"});
  all.check(
      "nearest", "Gauss-principle particles give the smallest outline error of all models.", "their error is the least",
      [](const Contest& contest) {
        const double least = contest.of("particles").finest().error;
        return std::ranges::all_of(contest.entries(),
                                   [least](const Entry& one) { return !(one.finest().error < least); })
                   ? 1.0
                   : 0.0;
      },
      Qualitative{.detector = "error of the finest resolution of each",
                  .reason = "their space holds the linear fields of the exact motion"});
}

void claim_ends(const Claims<Contest>& all, const Values& values) {
  const auto lasting = all.only_if(values.real("last") <= 3, "nobody knows how thin a drop they follow");
  for (const Named& model : {names[0], names[1]}) {
    claim_lasts(claims_of(lasting, model.id), model, values.real("last"), source);
  }
  claim_breaks(claims_of(all.only_if(values.real("last") >= 3, "they last until the drop is thin"), "dirichlet"),
               names[2], "the outline is drawn out, and nothing restores the place of a node in its cell", source);
}

void claims(const Values& values, const Claims<Results>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, t = {:g}", values.real("time"))).of(&Results::contest);
  claim_accuracy(claims, values);
  claim_kept(claims, values);
  claim_ends(claims, values);
}

Results compute(const Run& run) {
  const StretchingDrop drop = the_drop();
  return {contest(run,
                  drop_contenders(drop, {.mesh = run.integer("mesh"),
                                         .rings = run.integer("rings"),
                                         .overlapping = run.integer("overlapping"),
                                         .cells = run.integer("cells"),
                                         .sph = run.integer("sph")}),
                  trial_of(run))};
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  r.contest.show(exhibit, {.size = "radius", .error = "radius", .time = "1/strain rate"});
}

}  // namespace

Case drop_models() {
  Case c;
  c.title = "Which model should one take? A stretched drop by six of them";
  c.source = "P. G. L. Dirichlet, Abh. Kgl. Ges. Wiss. Goettingen 8 (1860) 3; A. M. Frank, doctoral thesis (1994)";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("time", 1.0, "1/strain rate", {0.1, 5}, "at which errors are compared"),
      real("last", 3.0, "1/strain rate", {0.1, 20}, "until which the models are followed"),
      integer("mesh", {32, 64, 64}, {16, 256}, "cells across the Lagrangian mesh, finest of four"),
      integer("rings", {28, 56, 56}, {14, 140}, "of free particles to the radius, finest of four"),
      integer("cells", {16, 32, 32}, {8, 64}, "rings of Dirichlet cells and of variable masses, finest of four"),
      integer("overlapping", {16, 40, 40}, {12, 80}, "spacings of overlapping particles to the radius, finest of four"),
      integer("sph", {28, 80, 80}, {12, 400}, "spacings of SPH particles to the radius, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::drop_models
