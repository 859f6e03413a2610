/*
Which model suits a standing wave? A standing wave in a tank, computed with six models: Gauss-principle particles, the
Lagrangian mesh, Dirichlet cells, variable-mass particles, dispersive shallow water in one dimension, and weakly
compressible SPH. The reference is the standing wave of Tadjbakhsh and Keller.

**Set-up.** Depth, gravity and density are 1; the tank is half a wavelength long. All models start from rest at maximum
elevation. Gauss-principle particles, mesh and cells have walls. SPH, whose walls are rows of particles, has the wave
and its mirror image in a periodic box instead, of which half is evaluated. Nodes of the variable-mass model are drawn
back to their initial positions, and the pressure stabilisation of cells is 0.01. Each model is refined in space and
time together.

**What is compared.** Elevations with the exact ones after 1.25 periods, when the surface is nearly level and falls
fastest, so that phase errors count in full: rms over the amplitude. The exact wave is second-order in $e = ka$, and
known to $e^2$. Each model then continues for six periods, unless it breaks down or its surface is in error by a quarter
of the amplitude.

**What to look at.** The error of Gauss-principle particles equals the uncertainty of the exact wave, on any grid. The
mesh takes a fiftieth of their time with nearly the same error. The energy error of the mesh comes from its steps: a
swing of $(\omega\tau)^2/4$. The error of the dispersive model converges to 5 % after this time, a phase error of its
equations, in a millisecond. Dirichlet cells are noisy and lose the wave within a few periods; variable-mass particles
retain it, with superposed short waves. SPH loses height, and beyond some twelve particles over the depth its error no
longer falls.

**Limits of this test.** Longer waves have less dispersion; higher ones tangle the mesh after some periods
(`standing_wave_mesh_life`) and break the cells at once (`standing_wave_free_lagrangian`).
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/standing_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/studies/side_by_side/tank_wave.hpp"

namespace seiche::validation::cases::standing_wave_models {

using exact::StandingWave;

const std::string source = "Tadjbakhsh and Keller (1960); Frank, Discrete models of incompressible fluid (1994)";
const Named particles{"particles", "Gauss particles"};
const Named mesh{"mesh", "the Lagrangian mesh"};
const Named variable_mass{"variable-mass", "particles of variable mass"};
const Named dispersive{"dispersive", "dispersive shallow water"};

StandingWave wave_of(const Values& values) {
  return {values.real("amplitude"), values.real("wavelength"), 1, 1};
}

TankWave tank_of(const StandingWave& wave, double amplitude) {
  const double length = std::numbers::pi / wave.wavenumber();
  return {.length = length,
          .water = {.period = 2 * length,
                    .highest = 3 * amplitude,
                    .elevation = [wave](double x) { return wave.elevation(x, 0); },
                    .velocity = [](Point) { return Point{}; },
                    .pressure =
                        [wave](Point at) {
                          return wave.pressure(at.x, std::min(at.y, wave.elevation(at.x, 0) - 1e-13), 0);
                        }},
          .speed = wave.frequency() / wave.wavenumber(),
          .amplitude = amplitude,
          .surface = [wave](double x, double t) { return wave.elevation(x, t); },
          .part =
              [length](double) {
                return TankWave::Part{0, length};
              }};
}

/// Markers at rest under the surface of the beginning, cells of equal volume.
dispersive_shallow_water_1d::Flow dispersive_of(const StandingWave& wave, double length, double spacing) {
  using namespace dispersive_shallow_water_1d;
  const Channel channel{.bottom = std::make_shared<LevelBottom>(1.0)};
  const auto cells = static_cast<std::size_t>(std::lround(length / spacing));
  const double k = wave.wavenumber();
  // What the surface adds up to x: it is e cos kx + B cos 2kx.
  const double first = (wave.elevation(0, 0) - wave.elevation(length, 0)) / 2;
  const double second = (wave.elevation(0, 0) + wave.elevation(length, 0)) / 2;
  return Flow(channel,
              moved_markers(
                  channel, equal_labels(channel, 0, length, cells),
                  [&](double x) {
                    return SurfaceMotion{wave.elevation(x, 0), 0, 0};
                  },
                  [=](double x) { return (first * std::sin(k * x) + second / 2 * std::sin(2 * k * x)) / k; }, 0));
}

Trial trial_of(const Values& values) {
  const StandingWave wave = wave_of(values);
  const double a = values.real("amplitude");
  const double length = std::numbers::pi / wave.wavenumber();
  return {.end = values.real("periods") * wave.period(),
          .last = values.real("last") * wave.period(),
          .looks = std::lround(4 * values.real("last")),
          .useless = 0.25,
          .useless_in_words = "the surface error exceeds a quarter of the amplitude",
          .energy_scale = a * a * length / 4,
          .reference_uncertainty = std::pow(wave.wavenumber() * a, 2)};
}

/// Of the surface of the dispersive model's own wave from the exact one, in the first harmonic, which a phase moves.
double equations_apart(const Values& values) {
  const StandingWave wave = wave_of(values);
  const exact::DispersiveStandingWave own(values.real("amplitude"), values.real("wavelength"), 1, 1);
  const double time = values.real("periods") * wave.period();
  return std::abs(std::cos(own.frequency() * time) - std::cos(wave.frequency() * time)) / std::numbers::sqrt2;
}

/// What steps of such a length make the energy swing by.
void claim_swing(const Claims<Contest>& all, const Named& model, double turn) {
  claims_of(all, model.id)
      .from("Frank (1994), chapter 1; potential turned into kinetic energy")
      .check(model.id + "-swing",
             fmt::format(
                 "The energy error agrees with the swing of the one-step scheme, (omega tau)^2/4, within a tenth: {}.",
                 model.name),
             "change over the energy", energy_of_finest,
             Bound{.limit = 0.1 * turn * turn / 4,
                   .reason = "the scheme conserves K (1 - (omega tau)^2/4) + P of a linear wave, hence that swing from "
                             "rest to a level surface; a tenth for nonlinearity and the surface not being level",
                   .expected = turn * turn / 4});
}

void claim_accuracy(const Claims<Contest>& all, const Values& values) {
  const Trial trial = trial_of(values);
  claims_of(all, "particles")
      .check("particles-surface",
             "The surface error of Gauss-principle particles is below (ka)^2, to which the exact wave is known.",
             "rms error of the surface over the amplitude", error_of_finest,
             Bound{.limit = trial.reference_uncertainty,
                   .reason = "(ka)^2: the exact wave is second-order; steps and cells add less"});
  claims_of(all, "mesh")
      .only_if(values.integer("mesh") <= 16, "finer meshes have a smaller error than the second-order exact wave")
      .check("mesh-order", "The surface error of the Lagrangian mesh converges at second order.",
             "order of the rms error of the surface", &Entry::order,
             Order{.theory = 2,
                   .tolerance = 0.4,
                   .reason = "second order in space and time; the uncertainty of the exact wave is half of the error "
                             "of the finest mesh, which changes the order between the last two by a quarter"});
  const double apart = equations_apart(values);
  claims_of(all, "dispersive")
      .from("Tadjbakhsh and Keller (1960); averaged Lagrangian of the model's equations")
      .check("dispersive-surface",
             "The surface error of the dispersive model agrees with the phase error of its equations within 10 %.",
             "rms error of the surface over the amplitude", error_of_finest,
             Bound{.limit = 0.1 * apart,
                   .reason = "expected: from the two frequencies alone; a tenth for harmonics, second-order in ka, and "
                             "the node spacing",
                   .expected = apart});
  const auto sph = claims_of(all, "sph");
  sph.fails({.value = 0,
             .reason = "beyond some twelve particles over the depth the error stays near 0.02: the initial particle "
                       "arrangement is not in equilibrium under its own sums, and the energy of its settling, a tenth "
                       "to a third of the wave energy, does not fall with the spacing"},
            values.integer("sph") > 12)
      .check(
          "sph-falls", "The surface error of SPH at the finest spacing is smaller than at twice that spacing.", "it is",
          [](const Entry& entry) { return entry.finest().error < entry.attempts.front().error; },
          Qualitative{.detector = "rms error of the surface",
                      .reason = "sums over neighbours converge, and the viscosity is proportional to the spacing: the "
                                "reduction must be visible at a quarter of the particle mass"});
}

void claims(const Values& values, const Claims<Contest>& all) {
  const Claims<Contest> claims = all.at(fmt::format("the finest, after {:g} periods", values.real("periods")));
  claim_accuracy(claims, values);
  const Trial trial = trial_of(values);
  const double omega = wave_of(values).frequency();
  const double speed = omega / wave_of(values).wavenumber();
  claim_energy(claims_of(claims, "particles"), particles, trial.end * speed * values.number("particles") / 0.15, 2,
               "one rounding per step of the kinetic and of the potential energy",
               "Frank (1994), chapter 6; exact for every space and step");
  const auto from_rest =
      claims.only_if(values.real("periods") == 1.25, "all energy is kinetic a quarter of a period later");
  claim_swing(from_rest, mesh, omega * 0.4 / values.number("mesh"));
  claim_swing(from_rest, dispersive, omega * 0.25 / values.number("markers"));
  const auto low = claims.only_if(values.real("amplitude") <= 0.05 && values.real("last") <= 8,
                                  "these models break down in higher waves and longer runs");
  for (const Named& model : {particles, mesh, variable_mass}) {
    claim_lasts(claims_of(low, model.id), model, trial.last, source);
  }
  claim_breaks(
      claims_of(claims.only_if(values.real("amplitude") >= 0.05 && values.real("last") >= 6, "lower waves last longer"),
                "dirichlet"),
      {"dirichlet", "Dirichlet cells"},
      "the offset of a node in its cell has no restoring force, and noise grows to the height of the wave",
      "Frank (1994), section 5.2, in words");
}

Contest compute(const Run& run) {
  const StandingWave wave = wave_of(run);
  const TankWave tank = tank_of(wave, run.real("amplitude"));
  const auto dispersive_flow = [&](double spacing) { return dispersive_of(wave, tank.length, spacing); };
  return contest(run, tank_contenders(tank, dispersive_flow, tank_sizes(run)), trial_of(run));
}

void show(const Contest& contest, const Values& /*values*/, evidence::Exhibit& exhibit) {
  contest.show(exhibit, {.size = "depth", .error = "amplitude", .time = "sqrt(depth/g)"});
}

void standing_wave_models(Case& c) {
  c.title = "Model comparison: a standing wave";
  c.source = "I. Tadjbakhsh, J. B. Keller, J. Fluid Mech. 8 (1960) 442; " + literature::frank;
  c.parameters = {
      real("amplitude", 0.05, "depth", {0.01, 0.2}, "first-order coefficient of cos kx"),
      real("wavelength", 6.0, "depth", {3, 12}, "wavelength; the walls are half a wavelength apart"),
      real("periods", 1.25, "1", {0.25, 10}, "time of the comparison in periods"),
      real("last", 6.0, "1", {0.25, 50}, "length of the runs in periods"),
      integer("particles", {4, 12, 12}, {4, 40}, "cells of the Gauss-principle particles per depth, finest of three"),
      integer("mesh", {16, 32, 32}, {8, 96}, "rows of the Lagrangian mesh, finest of four"),
      integer("cells", {12, 24, 24}, {12, 48}, "rows of Dirichlet cells and variable masses, the finest"),
      integer("markers", {32, 64, 64}, {8, 512}, "nodes of the dispersive model per depth, finest of four"),
      integer("sph", {8, 32, 32}, {8, 96}, "SPH particles over the depth, finest of three"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::standing_wave_models
