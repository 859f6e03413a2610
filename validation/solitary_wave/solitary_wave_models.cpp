/*
Which model suits a high solitary wave? The wave travels along a tank, computed with six models: Gauss-principle
particles, the Lagrangian mesh, Dirichlet cells, variable-mass particles, dispersive shallow water in one dimension, and
weakly compressible SPH. The reference is the exact wave of the Euler equations.

**Set-up.** Depth, gravity and density are 1; H/h = 0.5. All models start from the exact surface and velocities (SPH:
and pressures) in a tank at whose ends the wave is less than 0.004 of its height; walls at the ends, in SPH a periodic
box. The dispersive model starts from the solitary wave of its own equations with the same height. Nodes of the
variable-mass model are drawn back to their initial positions, and the pressure stabilisation of cells is 0.01. Each
model is refined in space and time together.

**What is compared.** Elevations of markers, nodes or the surface curve within a distance of 6 from the exact crest,
after it has travelled a distance of 8: rms over the height. Each model then continues to a distance of 18, unless it
breaks down or its surface is in error by a tenth of the height.

**What to look at.** Gauss-principle particles have the smallest error, a few times 0.0001, the lag of their steps.
Mesh, Dirichlet cells and variable-mass particles have errors of a few times 0.001, the mesh the smallest for its CPU
time. The error of the dispersive model converges to 5 %: its wave of this height has another shape and speed. SPH loses
height by viscosity. Variable-mass particles on the finest rows break down near the end of the run, when the surface has
slid over a cell beneath until that cell is empty.

**Limits of this test.** Shores and breaking are not covered (`run_up_gauss`, `overturning_gauss`). The error of the
dispersive model is smaller for a lower wave.
*/
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/studies/side_by_side/tank_wave.hpp"

namespace seiche::validation::cases::solitary_wave_models {

using exact::SolitaryWave;

const std::string source = "exact wave; Frank, Discrete models of incompressible fluid (1994)";
const Named particles{"particles", "Gauss particles"};
const Named mesh{"mesh", "the Lagrangian mesh"};
const Named variable_mass{"variable-mass", "particles of variable mass"};

constexpr double reach = 6;  ///< of the surface that counts, from the crest

SolitaryWave wave_of(const Values& values) {
  return SolitaryWave(values.real("amplitude"));
}

/// Distance at which the wave is less than four thousandths of its height.
double room(const SolitaryWave& wave) {
  return std::ceil(-std::log(0.001) / wave.decay_rate());
}

TankWave tank_of(const SolitaryWave& wave, double way) {
  const double start = room(wave);
  const double length = 2 * start + std::ceil(way);
  TankWave tank = solitary_tank(wave, start, length, length);
  tank.part = [start, c = wave.speed()](double t) {
    const double crest = start + c * t;
    return TankWave::Part{crest - reach, crest + reach};
  };
  return tank;
}

Trial trial_of(const Values& values) {
  const SolitaryWave wave = wave_of(values);
  require_within("way", values.real("way"), 0, values.real("last"));
  return {.end = values.real("way") / wave.speed(),
          .last = values.real("last") / wave.speed(),
          .looks = 8,
          .useless = 0.1,
          .useless_in_words = "the surface error exceeds a tenth of the height",
          .energy_scale = wave.kinetic_energy(),
          .reference_uncertainty = wave.uncertainty() / wave.amplitude()};
}

/// Of the wave of Serre's equations, of the same height, from the exact one at the time that is compared; equal weights
/// for equal water, as markers have.
double equations_apart(const Values& values) {
  const SolitaryWave wave = wave_of(values);
  const double a = values.real("amplitude");
  const double speed = std::sqrt(1 + a);
  const double rate = std::sqrt(3 * a / (1 + a)) / 2;
  const double lead = (speed - wave.speed()) * values.real("way") / wave.speed();
  constexpr int samples = 2000;
  Mean squares;
  for (int k = 0; k <= samples; ++k) {
    const double x = reach * (2.0 * k / samples - 1);
    const double serre = a / std::pow(std::cosh(rate * (x - lead)), 2);
    squares.add((serre - wave.elevation(x)) / a, 1 + serre);
  }
  return squares.rms();
}

void claim_accuracy(const Claims<Contest>& all, const Values& values) {
  const SolitaryWave wave = wave_of(values);
  const double k = wave.decay_rate();
  const double turn = k * 0.15 / values.number("particles");
  claims_of(all, "particles")
      .check("particles-surface",
             "The surface error of Gauss-principle particles is below the lag of their steps, (k c tau)^2/12 of the "
             "way, times the steepest slope.",
             "rms error of the surface over the height", error_of_finest,
             Bound{.limit = turn * turn / 12 * values.real("way") * std::tan(wave.maximum_slope()) / wave.amplitude(),
                   .reason = "the discrete gradient lags by (k c tau)^2/12 of the distance, k the decay rate of the "
                             "tails: that, times the steepest slope of the surface; the cells must add less"});
  claims_of(all, "mesh")
      .check("mesh-order", "The surface error of the Lagrangian mesh converges at second order.",
             "order of the rms error of the surface", &Entry::order,
             Order{.theory = 2,
                   .tolerance = 0.3,
                   .reason = "second order in space and time; for H/h = 0.5 cells of h/9 are not small, and the next "
                             "terms are visible"});
  for (const Named& model : {Named{"dirichlet", "Dirichlet cells"}, variable_mass}) {
    const double kh = k / values.number("cells");
    claims_of(all, model.id)
        .check(model.id + "-surface",
               fmt::format("The rms error of the surface is below (k h)^2, k the decay rate of the wave's tails: {}.",
                           model.name),
               "rms error of the surface over the height", error_of_finest,
               Bound{.limit = kh * kh,
                     .reason = "(k h)^2, k the decay rate of the tails: the exact wave satisfies the cell equations up "
                               "to second-order terms"});
  }
  const double apart = equations_apart(values);
  claims_of(all, "dispersive")
      .from("Serre (1953); exact wave")
      .check("dispersive-surface",
             "The surface error of the dispersive model agrees with the difference of its exact wave from Euler's "
             "within 10 %.",
             "rms error of the surface over the height", error_of_finest,
             Bound{.limit = 0.1 * apart,
                   .reason = "both exact waves are known to round-off; the claim requires a spacing error below a "
                             "tenth of the equation error",
                   .expected = apart});
  claim_dissipates(claims_of(all, "sph"), {"sph", "SPH"},
                   "artificial viscosity acts on approaching pairs only and is dissipative", source);
}

void claims(const Values& values, const Claims<Contest>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, after {:g} h", values.real("way")));
  claim_accuracy(claims, values);
  const double steps = values.real("way") * values.number("particles") / 0.15;
  claim_energy(claims_of(claims, "particles"), particles, steps, 2,
               "one rounding per step of the kinetic and of the potential energy",
               "Frank (1994), chapter 6; exact for every space and step");
  const auto moderate = claims.only_if(values.real("amplitude") <= 0.5 && values.real("last") <= 18,
                                       "these models break down in higher waves and longer runs");
  for (const Named& model : {particles, mesh, Named{"dispersive", "dispersive shallow water"}}) {
    claim_lasts(claims_of(moderate, model.id), model, trial_of(values).last, source);
  }
}

Contest compute(const Run& run) {
  const SolitaryWave wave = wave_of(run);
  const TankWave tank = tank_of(wave, run.real("last"));
  const auto dispersive = [&](double spacing) {
    using namespace dispersive_shallow_water_1d;
    const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
    return Flow(channel, solitary_markers(channel, 0, tank.length, spacing,
                                          {.amplitude = wave.amplitude(), .crest = room(wave)}));
  };
  return contest(run, tank_contenders(tank, dispersive, tank_sizes(run)), trial_of(run));
}

void show(const Contest& contest, const Values& /*values*/, evidence::Exhibit& exhibit) {
  contest.show(exhibit, {.size = "depth", .error = "height", .time = "sqrt(depth/g)"});
}

void solitary_wave_models(Case& c) {
  c.title = "Model comparison: a solitary wave";
  c.source = literature::dutykh_clamond + "; " + literature::frank;
  c.parameters = {
      real("amplitude", 0.5, "depth", {0.05, 0.6}, "crest above still water"),
      real("way", 8.0, "depth", {1, 50}, "distance travelled when errors are compared"),
      real("last", {12.0, 18.0, 18.0}, "depth", {1, 100}, "distance travelled at the end of the runs"),
      integer("particles", {3, 8, 8}, {2, 16}, "cells of the Gauss-principle particles per depth, finest of three"),
      integer("mesh", {24, 48, 48}, {8, 64}, "rows of the Lagrangian mesh, finest of four"),
      integer("cells", {8, 16, 16}, {8, 32}, "rows of Dirichlet cells and variable masses, the finest"),
      integer("markers", {32, 64, 64}, {8, 512}, "nodes of the dispersive model per depth, finest of four"),
      integer("sph", {7, 16, 16}, {6, 96}, "SPH particles over the depth, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::solitary_wave_models
