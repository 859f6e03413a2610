/*
The steep wave of `overturning_sph` overturns and plunges, computed with Gauss-principle particles, beside SPH and the
exact potential flow from the same initial state.

**Set-up.** One wavelength of a periodic layer, $d/L = 0.13$; the initial surface is a cosine of height $H = d$ with the
velocities of linear theory, which are an exact potential flow under any surface. Units of $1/k$, $g$ and the density.
Cubic splines on square cells, shifted at random at every step; six particles per cell side; a penalty on vorticity
gradients. SPH starts from the same velocities and exact pressures, as in its own case.

**What is compared.** The surface with the boundary-integral computation (`seiche exact overturning_wave`) at five times
up to a developed jet: the line of surface markers until the exact front is vertical, then the outline of the particles,
because markers in a jet thinner than a cell have no mass around them. The time of the first vertical front; the energy,
which changes by what the penalty dissipates. A table shows the distances beside the SPH ones, and the processor time of
both, which is not scored.

**What to look at.** Up to the vertical front the distance of the Gauss-principle particles from the exact surface is
smaller than the SPH distance by two orders of magnitude at equal processor time, and by more than one with a developed
jet; no resolution of `overturning_sph` is as accurate, up to 800 spacings per wavelength. The whole jet is accurate to
a fraction of a cell.

**Limits of this test.** The jet does not impact here; impact is tested with SPH (`flap_plunging_sph`).
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "validation/breaking/breaking_comparison.hpp"
#include "validation/breaking/free_particle_surface.hpp"
#include "validation/breaking/sph_overturning.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/particles/sph_steep_wave.hpp"
#include "validation/instruments/processor_time.hpp"

namespace seiche::validation::cases::overturning_gauss {

using exact::OverturningWave;
using gauss_particles::Flow;
const std::string source = "Longuet-Higgins and Cokelet (1976); Frank (1994), chapter 6";

constexpr double wavelength = 2 * std::numbers::pi;
constexpr long side = 6;  ///< particles to a cell's
/// Of its period, as far as potential flow is computed.
constexpr double last_phase = 0.6;

const auto& instants = overturning_instants;

SteepWave wave_of(const Values& values) {
  return {.amplitude = 0.5 * values.real("height") * wavelength,
          .wavelength = wavelength,
          .depth = values.real("depth") * wavelength,
          .gravity = 1};
}

/// One model on one lattice.
struct Computed {
  std::string model;
  double size = 0;                               ///< of a cell, or spacing of the particles
  double seconds = 0;                            ///< of the processor
  std::vector<Polylines> surfaces;               ///< at the instants
  std::vector<PolylineDistance> distances = {};  ///< there
};

struct Results {
  std::vector<double> times, limits = {};  ///< of the instants; of the finest lattice
  std::vector<Polylines> exact = {};       ///< there
  std::vector<Computed> particles = {};    ///< coarse, fine
  Computed sph = {};
  double vertical = 0;  ///< when the exact front is
  double turned = nan;  ///< first time with the markers' front past it
  double energy = 0;    ///< largest defect over the kinetic energy

  [[nodiscard]] const Computed& finest() const { return particles.back(); }
};

double cell_of(long cells) {
  return wavelength / static_cast<double>(cells);
}

double step_of(const SteepWave& wave, long cells) {
  return 0.1 * cell_of(cells) * wave.period() / wavelength;
}

Flow flow_of(const SteepWave& wave, long cells) {
  const SteepWaveStart start(wave.amplitude, wave.wavelength, wave.depth, wave.gravity);
  const double rows = wave.depth / cell_of(cells) * static_cast<double>(side);
  const ParticleWave particles{.depth = wave.depth,
                               .cells = cells,
                               .side = side,
                               .rows = static_cast<std::size_t>(std::lround(rows)),
                               .markers = static_cast<std::size_t>(10 * cells),
                               .surface = [&](double x) { return start.elevation(x); }};
  return particles.start([&](Point r) {
    const auto [u, v] = start.velocity(r.x, r.y);
    return Point{u, v};
  });
}

/// Also when the front is first vertical, and the energy's defect.
void turn_particles(Results& r, const SteepWave& wave, long cells) {
  const double began = processor_seconds();
  Flow flow = flow_of(wave, cells);
  const double kinetic = flow.energy();
  Computed one{.model = "Gauss particles", .size = cell_of(cells)};
  r.turned = nan;
  for (const double time : r.times) {
    march(flow, time, step_of(wave, cells), [&] {
      flow.observe();
      if (std::isnan(r.turned) && goes_backwards(flow.markers())) r.turned = flow.time();
    });
    one.surfaces.push_back(time > r.vertical
                               ? water_outline(flow, one.size / static_cast<double>(side), -0.75 * wave.depth)
                               : Polylines{marker_line(flow)});
  }
  r.energy = flow.ledger().largest_defect("energy") / kinetic;
  one.seconds = processor_seconds() - began;
  r.particles.push_back(std::move(one));
}

Computed turned_sph(const Run& run, const SteepWave& wave, const std::vector<double>& times) {
  const double began = processor_seconds();
  const SphOverturning setup{.wave = wave,
                             .columns = run.integer("columns"),
                             .settings = {.kernel = wcsph::KernelName::wendland_c2,
                                          .smoothing = 2,
                                          .gravity = wave.gravity,
                                          .density = 1,
                                          .sound_speed = 10 * std::sqrt(wave.gravity * wave.depth),
                                          .viscosity = wcsph::ArtificialViscosity{0.01}}};
  const SphOverturned turned = overturn(setup, times, 0.01 * wavelength, 1, run.part("SPH"));
  return {.model = "SPH", .size = turned.spacing, .seconds = processor_seconds() - began, .surfaces = turned.surfaces};
}

Results compute(const Run& run) {
  const SteepWave wave = wave_of(run);
  const OverturningWave exact = wave.exact(256, last_phase);
  run.progress(0.1);
  const long cells = run.integer("cells");
  Results r{.times = times_of(exact)};
  r.vertical = exact.vertical_tangent_time().value_or(nan);
  for (const double time : r.times) {
    r.exact.push_back(exact_surface(exact, time));
    r.limits.push_back(largest_distance(exact, time, cell_of(cells)));
  }
  turn_particles(r, wave, cells / 2);
  run.progress(0.2);
  turn_particles(r, wave, cells);
  run.progress(0.6);
  r.sph = turned_sph(run, wave, r.times);
  const auto measure = [&](Computed& one) {
    for (std::size_t i = 0; i < instants.size(); ++i) {
      one.distances.push_back(polyline_distance(one.surfaces.at(i), r.exact[i], wavelength));
    }
  };
  for (Computed& one : r.particles) measure(one);
  measure(r.sph);
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const SteepWave wave = wave_of(values);
  const long cells = values.integer("cells");
  const double cell = cell_of(cells);
  const double tau = step_of(wave, cells);
  const Claims<Results> claims = all.at(fmt::format("{} cells, {} particles per side, tau = {:.3g}", cells, side, tau));
  for (std::size_t i = 0; i < instants.size(); ++i) {
    claims.check(
        "distance-" + instants[i].id,
        "The surface " + instants[i].when +
            " agrees with potential flow within half a cell and the parts of a jet thinner than a cell.",
        "largest distance of the surfaces [1/k]",
        [i](const Results& r) -> Measurement {
          return {.value = r.finest().distances.at(i).largest,
                  .where = fmt::format("t = {:.3f}", r.times.at(i)),
                  .told = {.limit = r.limits.at(i)}};
        },
        breaking::near_surface(cell));
  }
  breaking::claim_vertical_front(
      claims, [](const Results& r) { return r.turned - r.vertical; }, cell * wave.period() / (2 * wavelength) + tau);
  claims.check(
      "convergence", "The surface halfway to a vertical front on cells half as wide is nearer to potential flow.",
      "rms distance, finer grid over coarser",
      [](const Results& r) { return r.finest().distances[0].rms / r.particles[0].distances[0].rms; },
      breaking::nearer_on_half_cells());
  claims.from("Frank (1994), chapter 6; exact for every space and step")
      .check("energy", "The energy change equals the dissipation of the penalty, to round-off.",
             "largest energy error over the kinetic energy", &Results::energy,
             Roundoff{.operations = std::ceil(last_phase * wave.period() / tau),
                      .scale = 2,
                      .reason = "one rounding per step of the kinetic and the potential energy"});
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  auto& figure =
      exhibit.figure("surfaces", "Overturning of the wave", "Finer grid of the Gauss-principle particles, and SPH.");
  for (std::size_t i = 0; i < instants.size(); ++i) {
    auto& panel =
        figure.panel({.x = "k x", .y = "k y", .title = fmt::format("t = {:.2f}", r.times[i]), .equal_aspect = true});
    const auto draw = [&](const std::string& name, const Polylines& lines, Role role) {
      for (const Polyline& line : lines) panel.line(&line == &lines.front() ? name : "", line.x, line.y, role);
    };
    draw("potential flow", r.exact[i], Role::exact);
    draw("Gauss particles", r.finest().surfaces[i], Role::computed);
    draw("SPH", r.sph.surfaces[i], Role::peer);
  }
  evidence::Table& table = add_table(exhibit, "models", "Distance from potential flow",
                                     "Root mean square at the five instants, in 1/k, and the processor time.",
                                     {"", "cell or spacing [1/k]"});
  for (const Instant& instant : instants) table.columns.emplace_back(instant.id, "1/k");
  table.columns.emplace_back("time", "s");
  std::vector<Computed> all = r.particles;
  all.push_back(r.sph);
  for (const Computed& one : all) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{one.model, one.size});
    for (const PolylineDistance& distance : one.distances) row.emplace_back(distance.rms);
    row.emplace_back(one.seconds);
  }
  for (std::size_t i = 0; i < instants.size(); ++i) {
    exhibit.measure("rms_distance_sph_" + instants[i].id, r.sph.distances[i].rms);
  }
}

void overturning_gauss(Case& c) {
  c.title = "Overturning of a steep wave: Gauss-principle particles beside SPH";
  c.source = source;
  c.parameters = {
      real("height", 0.13, "L", {0.02, 0.14}, "height H of the initial cosine"),
      real("depth", 0.13, "L", {0.1, 1}, "depth of the water at rest"),
      integer("cells", {48, 80, 80}, {32, 200}, "cells per wavelength; a second grid has half as many"),
      integer("columns", {100, 280, 280}, {40, 2000}, "particle spacings of SPH in a wavelength"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::overturning_gauss
