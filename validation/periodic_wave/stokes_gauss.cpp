/*
A periodic wave of 90 per cent of the greatest height travels over water half a wavelength deep. Frank's figure 9 shows
such waves, computed with free particles under Gauss's principle of least constraint, against Schwartz (1974).

**Set-up.** Wavelength $2\pi$, mean depth $\pi$, height 0.8, units of $g$ and of the density. Particles in columns and
rows that follow the exact surface carry the exact velocities; masses of the rows next to the surface and to the bottom
are end-corrected. The space of fields is that of cubic splines on square cells; markers trace the surface. The penalty
on gradients of vorticity holds down what gravity does to small eddies, because sums over particles are no exact
integrals.

**What is compared.** The surface after three periods with the exact one, moved by $c t$; the phase; momentum; the
energy, which changes by what the penalty takes and by nothing else.

**What to look at.** The crest keeps its shape, at 40 cells to the wavelength, with steps of 1/267 of a period. Frank's
own projection scheme (`scheme = dissipative`) loses a fifth of the energy in the first period.

**When it is no test.** Without the penalty a run of one period is better, one of five is lost.
*/
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/stokes_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "validation/case/case.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
using exact::StokesWave;
using gauss_particles::Flow;
using gauss_particles::LatticePlan;
using gauss_particles::SplineSpace;

const std::string source =
    "Frank, Discrete models of incompressible fluid (1994), figure 9; Schwartz, J. Fluid Mech. 62 (1974) 553";

constexpr double wavelength = 2 * std::numbers::pi;
constexpr double depth = std::numbers::pi;
constexpr double crest = wavelength / 2;  ///< at the beginning

struct Results {
  explicit Results(StokesWave of) : wave(std::move(of)) {}

  StokesWave wave;
  std::vector<double> time;    ///< at the end of every tenth of a period
  std::vector<double> error;   ///< rms of the markers' elevations
  std::vector<double> energy;  ///< change over the kinetic energy
  std::vector<Point> markers;  ///< at the end
  double end = 0;
  double rms = 0;
  double phase = 0;            ///< lead per period, in wavelengths
  double energy_defect = 0;    ///< after booking, over the kinetic energy
  double momentum_defect = 0;  ///< over the momentum
  double loss = 0;             ///< by the penalty, over the kinetic energy
  double free_particles = 0;
};

/// Rms difference of the markers from the exact surface whose crest is at `at`.
double difference(const StokesWave& wave, const std::vector<Point>& markers, double at) {
  Mean squares;
  for (const Point& marker : markers) squares.add(marker.y - wave.elevation(marker.x - at));
  return squares.rms();
}

/// Shift of the exact surface at which the difference is least, by golden section about `at`.
double best_shift(const StokesWave& wave, const std::vector<Point>& markers, double at) {
  const double part = (std::sqrt(5.0) - 1) / 2;
  double low = -0.05 * wavelength;
  double high = 0.05 * wavelength;
  while (high - low > 1e-9) {
    const double left = high - part * (high - low);
    const double right = low + part * (high - low);
    if (difference(wave, markers, at + left) < difference(wave, markers, at + right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return 0.5 * (low + high);
}

Flow flow_of(const StokesWave& wave, const Values& values) {
  const long cells = values.integer("cells");
  const long side = values.integer("particles_per_side");
  const double h = wavelength / static_cast<double>(cells);
  // The surface itself is the end of the exact field: points above it by rounding are put on it.
  const auto velocity = [&](Point r) {
    const double x = r.x - crest;
    const auto v = wave.velocity(x, std::min(r.y, wave.elevation(x) - 1e-13));
    return Point{v.u, v.v};
  };
  return Flow(gauss_particles::layer({.begin = 0,
                                      .end = wavelength,
                                      .columns = static_cast<std::size_t>(cells * side),
                                      .rows = static_cast<std::size_t>(std::lround(depth / h) * side),
                                      .surface = [&](double x) { return wave.elevation(x - crest); },
                                      .bottom = [](double) { return -depth; },
                                      .markers = 200}),
              std::make_unique<SplineSpace>(LatticePlan{.degree = static_cast<int>(values.integer("degree")),
                                                        .cell_x = h,
                                                        .left_wall = 0.0,
                                                        .period = wavelength,
                                                        .bottom = true,
                                                        .ground = {.level = -depth}},
                                            SplineSpace::Settings{.inner_fraction = 0.6}),
              velocity, {.gravity = 1, .penalty = values.real("penalty")}, {},
              values.text("scheme") == "conservative" ? gauss_particles::Stepping::conservative
                                                      : gauss_particles::Stepping::dissipative);
}

StokesWave wave_of(const Values& values) {
  return {values.real("height") / 2, wavelength, depth, 1};
}

Results compute(const Run& run) {
  Results r(wave_of(run));
  Flow flow = flow_of(r.wave, run);
  const double period = wavelength / r.wave.phase_speed();
  const long steps = run.integer("steps_per_period");
  const long total = steps * run.integer("periods");
  const double kinetic = flow.energy();
  const double first_momentum = flow.ledger().entry("momentum_x").initial;
  const long every = std::max(1L, steps / 10);
  for (long n = 1; n <= total; ++n) {
    flow.advance(period / static_cast<double>(steps));
    flow.observe();
    if (n % every == 0) {
      r.time.push_back(flow.time() / period);
      r.error.push_back(difference(r.wave, flow.markers(), crest + r.wave.phase_speed() * flow.time()));
      r.energy.push_back(flow.energy() / kinetic - 1);
      run.progress(static_cast<double>(n) / static_cast<double>(total));
    }
  }
  r.end = flow.time();
  r.markers = flow.markers();
  const double at = crest + r.wave.phase_speed() * flow.time();
  r.rms = difference(r.wave, r.markers, at);
  r.phase = best_shift(r.wave, r.markers, at) / wavelength / static_cast<double>(run.integer("periods"));
  r.energy_defect = flow.ledger().largest_defect("energy") / kinetic;
  r.momentum_defect = flow.ledger().entry("momentum_x").largest_defect / std::abs(first_momentum);
  r.loss = flow.model().penalty_loss() / kinetic;
  r.free_particles = flow.most_free_particles();
  return r;
}

void claims(const Values& values, const Claims<Results>& all) {
  const auto steps = static_cast<double>(values.integer("steps_per_period") * values.integer("periods"));
  const std::string resolution =
      fmt::format("{} cells, {} particles to a side, {} steps per period", values.integer("cells"),
                  values.integer("particles_per_side"), values.integer("steps_per_period"));
  const Claims<Results> claims = all.at(resolution);
  const auto published =
      claims.only_if(values.as_published("frank-fig-9"), "the independent program ran with the default parameters");
  published.check({.id = "surface",
                   .text = "After three periods the surface is the exact one.",
                   .quantity = "rms difference of the markers' elevations",
                   .unit = "1/k",
                   .source = source},
                  &Results::rms,
                  evidence::Bound{1.5 * 7.7e-4,
                                  "1.5 times the difference that an independent program of the same method found: "
                                  "0.1 per cent of the wave's height"});
  published.check({.id = "phase",
                   .text = "The wave travels at its speed.",
                   .quantity = "lead of the phase per period",
                   .unit = "wavelengths",
                   .source = source},
                  &Results::phase,
                  evidence::Bound{1.5 * 4e-5,
                                  "1.5 times what an independent program found; the steps alone make it lead by "
                                  "(omega tau)^2/24 = 2.3e-5"});
  published.check({.id = "loss",
                   .text = "The penalty takes next to nothing of the energy.",
                   .quantity = "energy taken in three periods over the kinetic energy",
                   .source = source},
                  &Results::loss, evidence::Bound{1.5 * 2.4e-5, "1.5 times what an independent program found"});
  const auto conservative = claims.only_if(values.text("scheme") == "conservative",
                                           "the projection scheme loses energy, and is not meant to keep it");
  conservative.check(
      {.id = "energy",
       .text = "The energy changes by what the penalty takes, to round-off.",
       .quantity = "largest defect over the kinetic energy",
       .source = "Frank (1994), chapter 6; exact for every space and step"},
      &Results::energy_defect,
      evidence::Roundoff{
          .operations = steps, .scale = 2, .reason = "one rounding per step of the kinetic and the potential energy"});
  claims.check(
      {.id = "momentum",
       .text = "The horizontal momentum is kept to round-off.",
       .quantity = "largest defect over the momentum",
       .source = "Frank (1994), chapter 6; the uniform flow is in the space"},
      &Results::momentum_defect,
      evidence::Roundoff{.operations = steps,
                         .scale = 50,
                         .reason = "one rounding per step of the sums of m g tau/2 and of the penalty's forces, "
                                   "which are up to 50 times the momentum"});
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  auto& profile = exhibit
                      .figure("profile", "The wave at the end",
                              fmt::format("Markers after {} periods, and the exact wave.", values.integer("periods")),
                              {"frank-fig-9"})
                      .panel({.x = "k (x - c t)", .y = "k y"});
  std::vector<double> x;
  std::vector<double> y;
  const double at = crest + r.wave.phase_speed() * r.end;
  for (const Point& marker : r.markers) {
    const double place = marker.x - at;
    x.push_back(place - wavelength * std::round(place / wavelength));
    y.push_back(marker.y);
  }
  std::vector<double> exact_x;
  std::vector<double> exact_y;
  for (int k = 0; k <= 400; ++k) {
    exact_x.push_back(wavelength * (k / 400.0 - 0.5));
    exact_y.push_back(r.wave.elevation(exact_x.back()));
  }
  profile.line("exact", exact_x, exact_y, Role::exact);
  profile.points("markers", x, y, Role::computed);
  auto& history = exhibit.figure("history", "Error of the surface and energy", "Against the time in periods.");
  history.panel({.x = "t/T", .y = "rms difference", .log_y = true}).line("surface", r.time, r.error, Role::computed);
  history.panel({.x = "t/T", .y = "(E - E(0))/K"}).line("energy", r.time, r.energy, Role::computed);
  exhibit.measure("phase_speed", r.wave.phase_speed());
  exhibit.measure("rms", r.rms);
  exhibit.measure("phase", r.phase);
  exhibit.measure("energy_defect", r.energy_defect);
  exhibit.measure("momentum_defect", r.momentum_defect);
  exhibit.measure("penalty_loss", r.loss);
  exhibit.measure("free_particles", r.free_particles);
}

}  // namespace

Case stokes_gauss() {
  Case c;
  c.title = "A steep periodic wave, by free particles under Gauss's principle";
  c.source = source;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("height", 0.8, "1/k", {0.01, 0.87}, "from trough to crest"),
      integer("cells", {40, 60, 80}, {8, 400}, "cells of the lattice to a wavelength"),
      integer("particles_per_side", 6, {3, 40}, "particles to a cell's side"),
      integer("steps_per_period", {267, 400, 533}, {10, 100000}, "steps to a period"),
      integer("periods", 3, {1, 1000}, "length of the run"),
      integer("degree", 3, {2, 4}, "degree of the splines"),
      real("penalty", 0.01, "1", {0, 10}, "C of the penalty on gradients of vorticity"),
      choice("scheme", std::string("conservative"), {"conservative", "dissipative"}, "time stepping"),
  };
  c.published = {{.tiles = {"frank-fig-9"}}};
  c.study = Study(claims, compute, show);
  return c;
}

}  // namespace seiche::validation::cases
