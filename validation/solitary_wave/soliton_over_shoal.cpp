/*
A solitary wave runs over a round shoal that takes away two fifths of the depth, and is gathered behind it: by the
hexahedral Lagrangian mesh, whose lowest nodes slide on the bottom, and by the dispersive shallow water in plan, over
the same bottom. Depth and gravity are 1.

**Set-up.** A channel of walls, 35 depths long and 6 wide. The shoal, $z = -1 + s\,(1 - r^2/16)^3$ within $r = 4$, has
its top on one wall, which mirrors it. The wave starts 12 depths before the top, that of the Euler equations on the
hexahedra, that of the Green-Naghdi equations in plan. Cells are as long and as wide as a layer of the mesh is high;
both models have the same cells and steps.

**What is compared.** The largest elevation at three places on the walls: over the top, two depths behind it, and
across the channel beside the top. Each model comes with the uncertainty that three of its meshes give. The plan model
leaves out what is of the order of $(\kappa h)^4$, with $\kappa^2 h^2 = 3a/(4(h + a))$ of the solitary wave of this
height over the top.

**What to look at.** Both models gather the wave in the lee, the plan model more: there the waves are steepest and
shortest. Across, where the bottom is level, they agree to half a per cent.
*/
#include <cmath>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "validation/case/case.hpp"
#include "validation/solitary_wave/shoal_waves.hpp"

namespace seiche::validation::cases::soliton_over_shoal {
namespace {

const std::string source = "Frank (1994), chapter 4: both models of waves in three dimensions";

/// Both models on cells of one size.
struct Pair {
  ShoalWave wave;
  ShoalRun hexahedra, plan;
};
using Results = std::vector<Pair>;  ///< the finest last

std::vector<ShoalWave> waves_of(const Values& values) {
  const auto finest = static_cast<std::size_t>(values.integer("layers"));
  std::vector<ShoalWave> waves;
  for (const std::size_t layers : {finest / 2, 3 * finest / 4, finest}) {
    waves.push_back({.amplitude = values.real("amplitude"), .height = values.real("shoal"), .layers = layers});
  }
  return waves;
}

/// Of the plan model's results.
double left_out(const ShoalWave& wave) {
  return std::pow(0.75 * wave.amplitude / (1 - wave.height + wave.amplitude), 2);
}

/// On the finest cells, with the uncertainty that all give.
evidence::GridConvergence converged(const Results& all, ShoalRun Pair::*model, std::size_t gauge) {
  std::vector<double> size;
  std::vector<double> value;
  for (const Pair& pair : all) {
    size.push_back(pair.wave.spacing());
    value.push_back((pair.*model).highest[gauge].value());
  }
  return evidence::grid_convergence(size, value, 2);
}

double highest(const Results& all, ShoalRun Pair::*model, std::size_t gauge) {
  return (all.back().*model).highest[gauge].value();
}

void claim_energy(const Claims<Results>& claims, const ShoalWave& finest, const std::string& id,
                  const std::string& name, ShoalRun Pair::*model) {
  claims.check(
      "energy-" + id, name + ": the energy stays, over the shoal too.", "largest relative change of the energy",
      [model](const Results& all) -> Measurement {
        const Worst& defect = (all.back().*model).energy_defect;
        return {.value = defect.value(), .where = fmt::format("t = {:.1f}", defect.where())};
      },
      Bound{.limit = 3 * finest.amplitude * std::pow(finest.tau(), 2) / 8 * finest.height,
            .reason = "(omega tau)^2/8, omega^2 = 3a, by which the energy differs from what the scheme keeps, times "
                      "the part by which the shoal can change the wave, that of the depth it takes"});
}

void claims(const Values& values, const Claims<Results>& all) {
  const ShoalWave finest = waves_of(values).back();
  const auto claims = all.at(fmt::format("h = {:g}, tau = {:g}, and two coarser", finest.spacing(), finest.tau()));
  claim_energy(claims, finest, "hexahedra", "Hexahedra", &Pair::hexahedra);
  claim_energy(claims, finest, "plan", "Plan", &Pair::plan);
  for (std::size_t g = 0; g < shoal_gauges.size(); ++g) {
    const ShoalGauge& gauge = shoal_gauges[g];
    claims.check(
        fmt::format("models-{}", gauge.id), fmt::format("Both models raise the water as high {}.", gauge.name),
        "difference of the largest elevations over its uncertainty",
        [g, finest](const Results& r) -> Measurement {
          const double hexahedra = highest(r, &Pair::hexahedra, g);
          const double plan = highest(r, &Pair::plan, g);
          const double grids =
              std::hypot(converged(r, &Pair::hexahedra, g).uncertainty, converged(r, &Pair::plan, g).uncertainty);
          return {.value = (hexahedra - plan) / std::hypot(grids, 2 * left_out(finest) * plan)};
        },
        Bound{.limit = 1,
              .reason = "the 95 % half-widths of both from three meshes, and what the plan model leaves out, (kappa "
                        "h)^4 with a coefficient of up to 2"});
    claims.check(
        fmt::format("resolved-{}", gauge.id), fmt::format("The hexahedra resolve the wave {}.", gauge.name),
        "uncertainty of the largest elevation, from three meshes, over the elevation",
        [g](const Results& r) {
          return converged(r, &Pair::hexahedra, g).uncertainty / highest(r, &Pair::hexahedra, g);
        },
        Bound{.limit = 2 * left_out(finest),
              .reason = "what is not known better says nothing about what the plan model leaves out"});
  }
  claims.check(
      "gathered", "The shoal gathers the wave: it is higher in the lee than across.",
      "largest elevation behind the top over that across, hexahedra",
      [](const Results& r) { return highest(r, &Pair::hexahedra, 1) / highest(r, &Pair::hexahedra, 2) > 1; },
      Qualitative{.detector = "it is larger", .reason = "the wave is slower over the shoal and turns"});
}

Results compute(const Run& run) {
  Results all;
  const std::vector<ShoalWave> waves = waves_of(run);
  for (const ShoalWave& wave : waves) {
    all.push_back({wave, run_hexahedra(wave), run_plan(wave)});
    run.progress(std::pow(wave.spacing() / waves.back().spacing(), -4));
  }
  return all;
}

void show(const Results& all, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("gauges", "Elevation on the walls",
                                "Over the top of the shoal, two depths behind it, and across, on the finest cells.");
  for (std::size_t g = 0; g < shoal_gauges.size(); ++g) {
    auto& panel = figure.panel({.x = "t [sqrt(depth/g)]", .y = fmt::format("z [depth], {}", shoal_gauges[g].name)});
    const Pair& finest = all.back();
    panel.line("hexahedra", finest.hexahedra.time, finest.hexahedra.elevation[g], Role::computed);
    panel.line("plan", finest.plan.time, finest.plan.elevation[g], Role::peer);
    exhibit.measure(fmt::format("hexahedra_{}", shoal_gauges[g].id), highest(all, &Pair::hexahedra, g));
    exhibit.measure(fmt::format("plan_{}", shoal_gauges[g].id), highest(all, &Pair::plan, g));
    exhibit.measure(fmt::format("hexahedra_{}_extrapolated", shoal_gauges[g].id),
                    converged(all, &Pair::hexahedra, g).extrapolated);
  }
}

}  // namespace

Case soliton_over_shoal() {
  Case c;
  c.title = "A solitary wave over a round shoal by both models of waves in three dimensions";
  c.source = "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), chapter 4";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("amplitude", 0.2, "depth", {0.05, 0.3}, "height of the incident wave"),
      real("shoal", 0.4, "depth", {0.05, 0.6}, "height of the shoal"),
      integer("layers", {4, 8, 8}, {4, 16}, "of the finest mesh; coarser ones have a half and three quarters of them"),
  };
  c.study = Study(claims, compute, show, source);
  return c;
}

}  // namespace seiche::validation::cases::soliton_over_shoal
