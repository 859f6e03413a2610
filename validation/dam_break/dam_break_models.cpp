/*
Which model should one take? A column of water twice as high as wide is let go at a wall and runs over a dry bed, by six
models: free particles under Gauss's principle, the Lagrangian mesh, Dirichlet cells, particles of variable mass,
overlapping particles, and weakly compressible SPH. The front that Martin and Moyce (1952) measured tells how far off
each is.

**Set-up.** Width $a$, gravity and density are 1; $T = t\sqrt{2g/a}$. Free particles are those of `collapse_gauss`, SPH
has the settings of `dam_break_sph_front` with a sound speed of ten times that of a free fall through the column's
height. Mesh and cells are rectangles with a wall and a bed, free elsewhere; overlapping particles have their mirror
images behind both. Each is refined in space and time together.

**What is compared.** The front with the measured points, with the one shift of the time origin that fits them best, for
a diaphragm of waxed paper had to melt first: the root mean square over the width, of the points up to T = 3.4. Then
each goes on to T = 5, unless it breaks down or its front is off by half of the width.

**What to look at.** Two models get there: free particles go through the points within what these are known by, on eight
cells to the width; SPH comes near as its viscosity falls with the spacing, and loses a fifth of the energy. The others
are no models for this: the mesh folds at the upper corner of the column, which becomes a straight piece of surface; of
the Dirichlet cells a triangle at the toe, where the water runs fastest, turns over; overlapping particles are pressed
through the bed, for single pressures are chequered; particles of variable mass want one height of the surface over
every place, and refuse a column. They give out the sooner the finer they are.

**When it is no test.** After the tongue has become thinner than a cell or a spacing. The discrete dispersive shallow
water has no vertical front.
*/
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/dam_break/column_contenders.hpp"

namespace seiche::validation::cases::dam_break_models {
namespace {

const std::string source = "Frank, Discrete models of incompressible fluid (1994); Martin and Moyce (1952)";
const Named particles{"particles", "free particles"};
const Named sph{"sph", "SPH"};

ColumnFront data_of(const Values& values) {
  return column_front("martin_moyce_tall_wide", values);
}

Trial trial_of(const Values& values) {
  const ColumnFront data = data_of(values);
  const double unit = std::sqrt(column_aspect);  // NOLINT(modernize-use-std-numbers): it happens to be 2
  double points = 0;
  for (const double T : data.T) points += T < values.real("time") - 0.2 ? 1 : 0;
  return {.end = values.real("time") / unit,
          .last = values.real("last") / unit,
          .looks = 20,
          .useless = 0.5,
          .useless_in_words = "the front is off by half of the column's width",
          .energy_scale = column_aspect * column_aspect / 2,
          .reference_uncertainty = data.uncertainty * std::sqrt(2 / points)};
}

struct Results {
  Contest contest;
};

void claims(const Values& values, const Claims<Results>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, T = {:g}", values.real("time"))).of(&Results::contest);
  const ColumnFront data = data_of(values);
  for (const Named& model : {particles, sph}) {
    claims_of(claims.only_if(values.real("time") <= 3.6, "later the tongue is thin"), model.id)
        .from(data.citation)
        .check(model.id + "-front",
               fmt::format("With one shift the front goes through the measured points: {}.", model.name),
               "rms difference of X/a", error_of_finest, through_points(data));
    claim_dissipates(claims_of(claims, model.id), model,
                     "the penalty of the free particles and the viscosity of SPH only take", source);
    claim_lasts(
        claims_of(claims.only_if(values.real("last") <= 5, "nobody knows how thin a tongue they follow"), model.id),
        model, trial_of(values).last, source);
  }
  claims_of(claims, "particles")
      .check("particles-energy-loss", "What the penalty takes from the free particles is no part of the flow.",
             "change over the energy of the beginning", energy_of_finest,
             Bound{.limit = 0.01 / static_cast<double>(values.integer("particles")),
                   .reason = "a hundredth for eddies of a cell at the front, which is a cell high: a cell of as many "
                             "as are in the width, of a column that falls as a whole"});
  claim_breaks(claims_of(claims, "mesh"), {"mesh", "the Lagrangian mesh"},
               "the right angle between top and face opens until it is straight, and there a corner of a cell folds",
               source);
  claim_breaks(claims_of(claims, "dirichlet"), {"dirichlet", "Dirichlet cells"},
               "the outline meets the bed at the toe, and cells cannot change the outline", source);
  claim_breaks(claims_of(claims, "overlapping"), {"overlapping", "overlapping particles"},
               "single multipliers are chequered by many times the pressure, and drive single particles at the bed",
               source);
  claim_breaks(claims_of(claims, "variable-mass"), {"variable-mass", "particles of variable mass"},
               "nodes of its surface slide along it as a function of x, and a face is none", source);
}

Results compute(const Run& run) {
  return {contest(run,
                  column_contenders(data_of(run), {.particles = run.integer("particles"),
                                                   .mesh = run.integer("mesh"),
                                                   .cells = run.integer("cells"),
                                                   .overlapping = run.integer("overlapping"),
                                                   .sph = run.integer("sph")}),
                  trial_of(run))};
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  r.contest.show(exhibit, {.size = "width", .error = "width", .time = "sqrt(width/g)"});
}

}  // namespace

Case dam_break_models() {
  Case c;
  c.title = "Which model should one take? A collapsing column by six of them";
  c.source =
      "J. C. Martin, W. J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952) 312; A. M. Frank, Discrete models of "
      "incompressible fluid, doctoral thesis (1994)";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("time", 3.6, "sqrt(width/2g)", {2.3, 6}, "at which errors are compared"),
      real("last", 5.0, "sqrt(width/2g)", {2.3, 6}, "until which the models are followed"),
      integer("particles", {8, 16, 16}, {4, 32}, "cells of the free particles to the width, finest of three"),
      integer("mesh", {16, 32, 32}, {4, 64}, "columns of the Lagrangian mesh, finest of three"),
      integer("cells", {16, 32, 32}, {4, 64}, "columns of Dirichlet cells and variable masses, finest of three"),
      integer("overlapping", {16, 32, 32}, {8, 64}, "overlapping particles to the width, finest of three"),
      integer("sph", {24, 60, 60}, {10, 200}, "SPH particles to the width, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::dam_break_models
