/*
Periodic waves of large amplitude travel without change of shape. Frank's figure 9 shows such waves, computed with
Gauss-principle particles, and the solution of Schwartz (1974).

**Set-up.** Three waves of length $2\pi$ on water of mean depth $\pi$, of heights 0.4, 0.6 and 0.8, in units of $g$ and
of the density: the last has 90 % of the maximum height. A fourth is nearly a train of solitary waves: length 30, depth
1, height 0.3, with 2.5 times as many cells and steps. Particles in columns and rows that follow the exact surface carry
the exact velocities, ten per cell side (the source states no number); masses of the rows next to surface and bed are
end-corrected. The space of fields consists of cubic splines on square cells; markers trace the surface. Gravity is the
potential energy of the water under the line of markers, Frank's (7), so that energy and momentum are exact.

**What is compared.** The surface after three periods with the exact one, translated by $c t$; the phase, whose lead or
lag follows from the time steps.

**What to look at.** The markers lie on the exact curves. The steepest wave needs ten particles: with 6, 8, 10, 12 and
16 per cell side its surface error is 0.0105, 0.0038, 0.0019, 0.0015 and 0.0016. Frank's projection scheme (`scheme =
dissipative`, `gravity = particles`) loses 20 % of the energy in the first period.

**A variant**, of the tier `full`. With `gravity = particles` sums over particles are not exact integrals, gravity feeds
small eddies, and the long wave is lost within a period unless a penalty on vorticity gradients (`penalty = 0.01`),
which is not Frank's, suppresses them; the energy that it dissipates is booked.
*/
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "seiche/exact/stokes_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/periodic_wave/surface_fit.hpp"

namespace seiche::validation::cases::stokes_gauss {

using exact::StokesWave;
using gauss_particles::Flow;
using gauss_particles::LatticePlan;
using gauss_particles::SplineSpace;

const std::string source =
    "Frank, Discrete models of incompressible fluid (1994), figure 9; Schwartz, J. Fluid Mech. 62 (1974) 553";

constexpr std::size_t drawn = 4;  ///< every such marker

/// A wave and how finely it is computed.
struct SetUp {
  std::string id;  ///< ending of the ids of its claims and numbers; empty for the principal one
  double height, length, depth;
  long cells;  ///< to a wavelength
  long steps;  ///< to a period

  [[nodiscard]] StokesWave wave() const { return {height / 2, length, depth, 1}; }
  [[nodiscard]] double cell() const { return length / static_cast<double>(cells); }
  [[nodiscard]] double crest() const { return length / 2; }  ///< at the beginning
  [[nodiscard]] std::string named(const std::string& what) const { return id.empty() ? what : what + "_" + id; }
  [[nodiscard]] std::string name() const {
    return fmt::format("H = {:g}, L = {:.4g}, d = {:.4g}", height, length, depth);
  }
};

/// That of the parameters, or those of the figure, the steepest first.
std::vector<SetUp> set_ups(const Values& values) {
  const long cells = values.integer("cells_per_length");
  const long steps = values.integer("steps_per_period");
  const double length = values.real("length");
  const double depth = values.real("depth");
  if (values.real("height") > 0) return {{"", values.real("height"), length, depth, cells, steps}};
  return {{"", 0.8, length, depth, cells, steps},
          {"h06", 0.6, length, depth, cells, steps},
          {"h04", 0.4, length, depth, cells, steps},
          {"long", 0.3, 30, 1, cells * 5 / 2, steps * 5 / 2}};
}

struct WaveRun {
  explicit WaveRun(SetUp of) : set_up(std::move(of)), wave(set_up.wave()) {}

  SetUp set_up;
  StokesWave wave;
  std::vector<double> time;    ///< at the end of every tenth of a period, in periods
  std::vector<double> error;   ///< rms of the markers' elevations over the height
  std::vector<double> energy;  ///< change over the kinetic energy
  std::vector<Point> markers;  ///< at the end
  double end = 0;
  double rms = 0;
  double phase = 0;  ///< lead per period, in wavelengths
  double loss = 0;   ///< by the penalty, over the kinetic energy
  double free_particles = 0;
};

using Results = std::vector<WaveRun>;

Flow flow_of(const SetUp& s, const StokesWave& wave, const Values& values) {
  const long side = values.integer("per_cell");
  const bool on_surface = values.text("gravity") == "surface";
  std::optional<gauss_particles::SurfaceLine> line;
  if (on_surface) line = gauss_particles::SurfaceLine{.period = s.length, .exact_energy = true};
  // The surface itself is the end of the exact field: points above it by rounding are put on it.
  const auto velocity = [&](Point r) {
    const double x = r.x - s.crest();
    const auto v = wave.velocity(x, std::min(r.y, wave.elevation(x) - 1e-13));
    return Point{v.u, v.v};
  };
  return Flow(gauss_particles::layer({.end = s.length,
                                      .columns = static_cast<std::size_t>(s.cells * side),
                                      .rows = static_cast<std::size_t>(std::lround(s.depth / s.cell()) * side),
                                      .surface = [&](double x) { return wave.elevation(x - s.crest()); },
                                      .bottom = [&](double) { return -s.depth; },
                                      .markers = on_surface ? 20 * static_cast<std::size_t>(s.cells) : 200}),
              std::make_unique<SplineSpace>(LatticePlan{.degree = static_cast<int>(values.integer("degree")),
                                                        .cell_x = s.cell(),
                                                        .left_wall = 0.0,
                                                        .period = s.length,
                                                        .bottom = true,
                                                        .ground = {.level = -s.depth}},
                                            SplineSpace::Settings{.inner_fraction = on_surface ? 0.9 : 0.6}),
              velocity, {.gravity = 1, .penalty = values.real("penalty"), .surface = line}, {},
              values.text("scheme") == "conservative" ? gauss_particles::Stepping::conservative
                                                      : gauss_particles::Stepping::dissipative);
}

WaveRun follow(const SetUp& s, const Values& values, const std::function<void(double)>& progress) {
  WaveRun r(s);
  Flow flow = flow_of(s, r.wave, values);
  const double period = s.length / r.wave.phase_speed();
  const long total = s.steps * values.integer("periods");
  const double kinetic = flow.energy();
  const auto crest = [&] { return s.crest() + r.wave.phase_speed() * flow.time(); };
  const Elevation exact = [&](double x) { return r.wave.elevation(x); };
  const long every = std::max(1L, s.steps / 10);
  for (long n = 1; n <= total; ++n) {
    flow.advance(period / static_cast<double>(s.steps));
    if (n % every == 0) {
      r.time.push_back(flow.time() / period);
      r.error.push_back(surface_rms(exact, flow.markers(), crest()) / s.height);
      r.energy.push_back(flow.energy() / kinetic - 1);
      progress(static_cast<double>(n) / static_cast<double>(total));
    }
  }
  r.end = flow.time();
  r.markers = flow.markers();
  r.rms = surface_rms(exact, r.markers, crest());
  r.phase = surface_lead(exact, s.length, r.markers, crest()) / values.number("periods");
  r.loss = flow.model().penalty_loss() / kinetic;
  r.free_particles = flow.most_free_particles();
  return r;
}

Results compute(const Run& run) {
  Results results;
  const std::vector<SetUp> all = set_ups(run);
  const auto count = static_cast<double>(all.size());
  for (const SetUp& s : all) {
    const auto before = static_cast<double>(results.size());
    results.push_back(follow(s, run, [&](double done) { run.progress((before + done) / count); }));
  }
  return results;
}

/// Claims of the wave's shape, speed and energy: what the conservative scheme is for.
void claim_wave(const SetUp& s, const Values& values, const Claims<WaveRun>& claims) {
  const StokesWave wave = s.wave();
  const double turn = 2 * std::numbers::pi / static_cast<double>(s.steps);
  const auto periods = values.number("periods");
  const bool on_surface = values.text("gravity") == "surface";
  const Bound line{0.01 * s.height, "1 % of the height: the line width of a figure in which the wave is 3 cm high"};
  claims.check(s.named("surface"),
               fmt::format("The surface after {1:g} periods agrees with the exact wave within 1 % of the height ({0}).",
                           s.name(), periods),
               "rms difference of the markers' elevations", &WaveRun::rms, line);
  const double linear = std::sqrt(std::tanh(wave.wavenumber() * s.depth) / wave.wavenumber());
  const double excess = wave.phase_speed() / linear - 1;
  claims.only_if(excess > 0.01, "the height of this wave adds less than 1 % to its celerity")
      .check(
          s.named("phase"),
          fmt::format("The celerity agrees with the exact wave plus the phase lead of the time steps ({}).", s.name()),
          "lead of the phase per period [wavelengths]", &WaveRun::phase,
          Bound{.limit = 0.01 * excess,
                .reason = fmt::format(
                    "1 % of the nonlinear excess celerity, {:.3f} of the linear celerity; expected: {}", excess,
                    on_surface ? "-(omega tau)^2/12, the lag of the discrete gradient"
                               : "(omega tau)^2/24, leapfrog's lead"),
                .expected = on_surface ? -turn * turn / 12 : turn * turn / 24});
  claims.only_if(values.real("penalty") > 0, "there is no penalty")
      .check(s.named("loss"),
             fmt::format("The energy dissipated by the penalty is below 1 % of the loss of the projection scheme ({}).",
                         s.name()),
             "dissipated energy over the kinetic energy", &WaveRun::loss,
             Bound{0.01 * 2 * std::numbers::pi * turn * periods,
                   "1 % of the loss of Frank's projection scheme with the same steps, (tau/2) sum m |a|^2 = tau "
                   "omega^2 times the kinetic energy per unit of time in a linear wave"});
  claims.from("Frank (1994), chapter 6; exact for every space and step")
      .only_if(values.real("penalty") == 0 && on_surface,
               "a penalty dissipates energy, and the energy of particles is a different one")
      .check(
          s.named("energy"), fmt::format("The energy is conserved to round-off ({}).", s.name()),
          "largest change over the kinetic energy", [](const WaveRun& r) { return worst(r.energy); },
          Roundoff{.operations = static_cast<double>(s.steps) * periods,
                   .scale = 2,
                   .reason = "one rounding per step of the kinetic and of the potential energy"});
}

void claims(const Values& values, const Claims<Results>& all) {
  const std::vector<SetUp> waves = set_ups(values);
  for (std::size_t k = 0; k < waves.size(); ++k) {
    const Claims<WaveRun> claims =
        all.entry(k).at(fmt::format("{} cells, {} particles per side, {} steps per period", waves[k].cells,
                                    values.integer("per_cell"), waves[k].steps));
    claim_wave(waves[k], values,
               claims.only_if(values.text("scheme") == "conservative",
                              "the projection scheme loses energy, and with it the wave"));
  }
}

void draw_profile(evidence::Figure& figure, const WaveRun& r) {
  auto& panel = figure.panel({.x = "(x - c t)/L", .y = "y", .title = r.set_up.name()});
  const double length = r.set_up.length;
  const double at = r.set_up.crest() + r.wave.phase_speed() * r.end;
  std::vector<double> x, y;
  for (std::size_t k = 0; k < r.markers.size(); k += drawn) {
    const double place = (r.markers[k].x - at) / length;
    x.push_back(place - std::round(place));
    y.push_back(r.markers[k].y);
  }
  const std::vector<double> places = evenly(-0.5, 0.5, 401);
  panel.points("markers", x, y, Role::computed);
  panel.line("exact", places, each(places, [&](double p) { return r.wave.elevation(length * p); }), Role::exact);
}

void show(const Results& results, const Values& values, evidence::Exhibit& exhibit) {
  auto& profiles =
      exhibit.figure("profiles", "Travelling waves of large amplitude",
                     fmt::format("Every fourth marker after {} periods, and the exact waves. Units: g = 1, density 1.",
                                 values.integer("periods")),
                     {"frank-fig-9"});
  for (const WaveRun& r : results) draw_profile(profiles, r);
  auto& history = exhibit.figure("history", "Error of the surface and energy", "Against the time in periods.");
  auto& errors = history.panel({.x = "t/T", .y = "rms difference/H", .log_y = true});
  auto& energies = history.panel({.x = "t/T", .y = "(E - E(0))/K"});
  for (const WaveRun& r : results) {
    errors.line(r.set_up.name(), r.time, r.error, Role::computed);
    energies.line(r.set_up.name(), r.time, r.energy, Role::computed);
    exhibit.measure(r.set_up.named("free_particles"), r.free_particles);
  }
}

void stokes_gauss(Case& c) {
  c.title = "Steep periodic waves: Gauss-principle particles";
  c.source = source;
  c.parameters = {
      real("height", 0.0, "1", {0, 2}, "from trough to crest; 0: the four waves of the figure"),
      real("length", 2 * std::numbers::pi, "1", {0.1, 1000}, "of a wave; of all in the figure except the long one"),
      real("depth", std::numbers::pi, "1", {0.1, 1000}, "mean depth; of all in the figure except the long one"),
      integer("cells_per_length", {20, 40, 60}, {8, 400}, "cells per wavelength"),
      integer("per_cell", {10, 6, 6}, {3, 40}, "particles per cell side"),
      integer("steps_per_period", {134, 267, 400}, {10, 100000}, "steps to a period"),
      integer("periods", 3, {1, 1000}, "length of the run"),
      integer("degree", 3, {2, 4}, "degree of the splines"),
      real("penalty", {0, 0.01, 0.01}, "1", {0, 10}, "C of the penalty on vorticity gradients, not in the source"),
      choice("gravity", {"surface", "particles", "particles"}, {"particles", "surface"},
             "on every particle, which needs the penalty, or as the potential energy under the line of markers"),
      choice("scheme", "conservative", {"conservative", "dissipative"},
             "time stepping; dissipative: with gravity = particles"),
  };
  c.published = {{.tiles = {"frank-fig-9"}, .stated = {"gravity", "penalty"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::stokes_gauss
