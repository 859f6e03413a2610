/*
A solitary wave passes a round shoal that reduces the depth by 40 % and is focused behind it: hexahedral Lagrangian
mesh, whose lowest nodes slide on the bed, and dispersive shallow water in 2DH, over the same bathymetry. Depth and
gravity are 1.

**Set-up.** A channel between walls, 35 long and 6 wide. The shoal, $z = -1 + s\,(1 - r^2/16)^3$ within $r = 4$, has its
top at one wall, a plane of symmetry. The wave starts at a distance of 12 before the top, a wave of the Euler equations
on the hexahedra, a wave of the Green-Naghdi equations in 2DH. Cells are as long and as wide as a layer of the mesh is
high; both models have the same cells and steps.

**What is compared.** Maximum elevation at three positions on the walls: over the top, a distance of 2 behind it, and
across the channel beside the top. Three meshes of each model give its uncertainty. The 2DH model neglects terms of
order $(\kappa h)^4$, with $\kappa^2 h^2 = 3a/(4(h + a))$ of the solitary wave of this height over the top.

**What to look at.** Both models focus the wave in the lee, the 2DH model more: there the waves are steepest and
shortest. Across, where the bed is level, they agree to 0.5 %.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/exact/model_waves.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/models/dispersive_shallow_water_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_3d/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/mesh/impulsive_start.hpp"
#include "validation/instruments/peak.hpp"

namespace seiche::validation::cases::soliton_over_shoal {

// A solitary wave runs along a channel over a smooth round shoal, by both models of waves in three dimensions.
//
// Units: depth away from the shoal and gravity are 1; z counts from still water. The channel is begin <= x <= end,
// 0 <= y <= width, all its sides walls; the shoal's top is on the wall y = 0, which mirrors it.

struct ShoalWave {
  static constexpr double begin = -5;
  static constexpr double end = 30;
  static constexpr double width = 6;
  static constexpr double crest = 5;   ///< of the wave at the start
  static constexpr double top = 17;    ///< of the shoal
  static constexpr double radius = 4;  ///< of the shoal

  double amplitude = 0.2;
  double height = 0.4;     ///< of the shoal
  std::size_t layers = 3;  ///< of the hexahedral mesh, whose cells are as long and as wide as a layer is high
  double time = 14;

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(layers); }
  [[nodiscard]] double tau() const { return 0.4 * spacing(); }
  [[nodiscard]] std::size_t columns() const { return cells(end - begin); }
  [[nodiscard]] std::size_t rows() const { return cells(width); }
  /// z = -1 + height (1 - (r/radius)^2)^3 within the radius, as a spline that both models see.
  [[nodiscard]] std::shared_ptr<const PlanBottom> bottom() const {
    constexpr double lines = 0.25;
    return std::make_shared<SplineBottom>(
        SplineBottom::sampled({.begin = begin - 1, .end = end + 1, .south = -1, .north = width + 1, .spacing = lines},
                              [this](double x, double y) {
                                const double inside = 1 - (std::pow(x - top, 2) + y * y) / (radius * radius);
                                return -1 + (inside > 0 ? height * inside * inside * inside : 0.0);
                              }));
  }

 private:
  [[nodiscard]] std::size_t cells(double of) const { return static_cast<std::size_t>(std::lround(of / spacing())); }
};

/// Where elevations are taken, on the walls: over the top and behind it on the shoal's side, beside the shoal across.
struct ShoalGauge {
  const char* id;
  const char* name;
  double x;
  bool across;
};

inline constexpr std::array<ShoalGauge, 3> shoal_gauges{{{"top", "over the top of the shoal", ShoalWave::top, false},
                                                         {"lee", "two depths behind it", ShoalWave::top + 2, false},
                                                         {"beside", "across, beside the top", ShoalWave::top, true}}};

struct ShoalRun {
  std::array<Peak, 3> highest;  ///< at the gauges
  std::array<std::vector<double>, 3> elevation;
  std::vector<double> time;
  Worst energy_defect;  ///< relative
};

/// Of a row of nodes at a place: the parabola through the three nearest.
double elevation_at(std::span<const double> x, std::span<const double> z, double place) {
  const auto after = std::upper_bound(x.begin() + 1, x.end() - 1, place);
  auto k = static_cast<std::size_t>(after - x.begin());
  if (place - x[k - 1] < x[k] - place) --k;
  k = std::clamp<std::size_t>(k, 1, x.size() - 2);
  const double left = (z[k] - z[k - 1]) / (x[k] - x[k - 1]);
  const double right = (z[k + 1] - z[k]) / (x[k + 1] - x[k]);
  const double bend = (right - left) / (x[k + 1] - x[k - 1]);
  return z[k] + (place - x[k]) * (left + bend * (place - x[k - 1]));
}

/// @param surface  x and z of the surface nodes of a flow
template <class Flow, class Surface>
ShoalRun followed(Flow& flow, const ShoalWave& wave, const Surface& surface) {
  ShoalRun run;
  const double energy = flow.energy();
  const auto observe = [&] {
    const auto [x, z] = surface(flow);
    const std::size_t row = flow.shape().columns + 1;
    run.time.push_back(flow.time());
    for (std::size_t g = 0; g < shoal_gauges.size(); ++g) {
      const ShoalGauge& gauge = shoal_gauges[g];
      const double level = gauge.across ? elevation_at(x.last(row), z.last(row), gauge.x)
                                        : elevation_at(x.first(row), z.first(row), gauge.x);
      run.elevation[g].push_back(level);
      run.highest[g].add(flow.time(), level);
    }
    run.energy_defect.add(flow.energy() / energy - 1, flow.time());
  };
  observe();
  march(flow, wave.time, wave.tau(), observe);
  return run;
}

/// From the solitary wave of the Euler equations on the hexahedral mesh, from that of the Green-Naghdi equations in
/// plan; spacing and steps are the same.
ShoalRun run_hexahedra(const ShoalWave& wave) {
  const exact::SolitaryWave solitary(wave.amplitude);
  lagrangian_mesh_3d::Mesh mesh = lagrangian_mesh_3d::layer_mesh(
      {.begin = ShoalWave::begin,
       .end = ShoalWave::end,
       .north = ShoalWave::width,
       .columns = wave.columns(),
       .rows = wave.rows(),
       .layers = wave.layers,
       .elevation = [&](double x, double) { return solitary.elevation(x - ShoalWave::crest); },
       .bottom = wave.bottom()});
  const std::vector<lagrangian_mesh_3d::Vector> velocities =
      impulsive_start(mesh, [&](double x, double) { return solitary.surface_potential(x - ShoalWave::crest); });
  lagrangian_mesh_3d::Flow flow(std::move(mesh), velocities);
  return followed(flow, wave, [](const auto& f) { return std::pair{f.surface_x(), f.surface_z()}; });
}

ShoalRun run_plan(const ShoalWave& wave) {
  const exact::SerreSolitary solitary(wave.amplitude);
  dispersive_shallow_water_2d::Flow flow(
      dispersive_shallow_water_2d::rectangular_lattice(
          {.begin = ShoalWave::begin,
           .end = ShoalWave::end,
           .north = ShoalWave::width,
           .columns = wave.columns(),
           .rows = wave.rows(),
           .elevation = [&](double x, double) { return solitary.elevation(x - ShoalWave::crest); },
           .bottom = wave.bottom()}),
      [&](double x, double) {
        const double u = solitary.depth_averaged_velocity(x - ShoalWave::crest);
        const double w = (u - solitary.speed()) * solitary.elevation_slope(x - ShoalWave::crest);
        return dispersive_shallow_water_2d::Velocity{u, 0, w};
      });
  return followed(flow, wave, [](const auto& f) { return std::pair{f.x(), f.z()}; });
}

const std::string source = "Frank (1994), chapter 4: both models of waves in three dimensions";

/// Both models on cells of one size.
struct Pair {
  ShoalWave wave;
  ShoalRun hexahedra, plan;
};
using Results = std::vector<Pair>;  ///< the finest last

std::vector<ShoalWave> waves_of(const Values& values) {
  const auto finest = values.count("layers");
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
  const auto highest = [&](const Pair& pair) { return (pair.*model).highest[gauge].value(); };
  return evidence::grid_convergence(each(all, [](const Pair& pair) { return pair.wave.spacing(); }), each(all, highest),
                                    2);
}

double highest(const Results& all, ShoalRun Pair::*model, std::size_t gauge) {
  return (all.back().*model).highest[gauge].value();
}

void claims(const Values& values, const Claims<Results>& all) {
  const ShoalWave finest = waves_of(values).back();
  const auto claims = all.at(fmt::format("h = {:g}, tau = {:g}, and two coarser", finest.spacing(), finest.tau()));
  for (const auto& [id, name, model] :
       {std::tuple{"hexahedra", "Hexahedral mesh", &Pair::hexahedra}, std::tuple{"plan", "2DH model", &Pair::plan}}) {
    claims.where("t = {:.1f}")
        .check(
            fmt::format("energy-{}", id),
            fmt::format("The energy change is at most 3 a tau^2/8, the swing of the scheme, times the relative height "
                        "of the shoal ({}).",
                        name),
            "largest relative change of the energy",
            [run = model](const Results& r) { return (r.back().*run).energy_defect; },
            Bound{.limit = 3 * finest.amplitude * std::pow(finest.tau(), 2) / 8 * finest.height,
                  .reason = "(omega tau)^2/8, omega^2 = 3a, the difference of energy from the conserved quantity of "
                            "the scheme, times the relative change of the wave by the shoal, its height over the "
                            "depth"});
  }
  for (std::size_t g = 0; g < shoal_gauges.size(); ++g) {
    const ShoalGauge& gauge = shoal_gauges[g];
    claims.check(
        fmt::format("models-{}", gauge.id),
        fmt::format("The maximum elevations of both models {} agree within the uncertainty of three meshes and the "
                    "neglected terms (kappa h)^4.",
                    gauge.name),
        "difference of the maximum elevations over its uncertainty",
        [g, finest](const Results& r) -> Measurement {
          const double hexahedra = highest(r, &Pair::hexahedra, g);
          const double plan = highest(r, &Pair::plan, g);
          const double grids =
              std::hypot(converged(r, &Pair::hexahedra, g).uncertainty, converged(r, &Pair::plan, g).uncertainty);
          return {.value = (hexahedra - plan) / std::hypot(grids, 2 * left_out(finest) * plan)};
        },
        Bound{.limit = 1,
              .reason = "the 95 % half-widths of both from three meshes, and the terms neglected by the 2DH model, "
                        "(kappa h)^4 with a coefficient of up to 2"});
    claims.check(
        fmt::format("resolved-{}", gauge.id),
        fmt::format("The uncertainty of the maximum elevation {} with hexahedra is below the terms (kappa h)^4 that "
                    "the 2DH model neglects.",
                    gauge.name),
        "uncertainty of the maximum elevation, from three meshes, over the elevation",
        [g](const Results& r) {
          return converged(r, &Pair::hexahedra, g).uncertainty / highest(r, &Pair::hexahedra, g);
        },
        Bound{.limit = 2 * left_out(finest),
              .reason = "a larger uncertainty would exceed the terms neglected by the 2DH model"});
  }
  claims.check(
      "gathered", "The maximum elevation in the lee of the shoal exceeds the elevation across the channel.",
      "maximum elevation behind the top over that across, hexahedra",
      [](const Results& r) { return highest(r, &Pair::hexahedra, 1) / highest(r, &Pair::hexahedra, 2) > 1; },
      Qualitative{.detector = "larger in the lee", .reason = "the wave is slower over the shoal and refracts"});
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

void soliton_over_shoal(Case& c) {
  c.title = "Solitary wave over a round shoal: 2DH model and hexahedral mesh";
  c.source = literature::frank + ", chapter 4";
  c.parameters = {
      real("amplitude", 0.2, "depth", {0.05, 0.3}, "height of the incident wave"),
      real("shoal", 0.4, "depth", {0.05, 0.6}, "height of the shoal"),
      integer("layers", {4, 8, 8}, {4, 16}, "of the finest mesh; coarser ones have a half and three quarters of them"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::soliton_over_shoal
