/*
A solitary wave climbs a vertical wall or a plane slope, computed with Gauss-principle particles. The exact run-up of
the Euler equations is known to many digits, at a wall (`wall_run_up_exact`) and on slopes down to 1:3
(`slope_run_up_exact`). Depth and gravity are 1.

**Set-up.** The exact solitary wave, with its velocities, starts where less than 0.4 % of its height reaches toe or
wall. Cubic splines on square cells that follow the bed; the toe of a slope is rounded over a quarter of a depth on
either side, because the bed slope has to be continuous. Cells count as full from a quarter of their mass on, because
the tongue is thin. The penalty on vorticity gradients is on ($C = 0.01$). Massless markers trace the surface; the
highest one beyond the toe, or at the wall, is the run-up.

**What is compared.** Three grids with 1/2, 3/4 and all of the cells, and of the particles per cell side with them: sums
over particles are not exact integrals, an error that refinement of the cells alone does not reduce. The run-up with the
exact one; on slopes also with the measurements of Hall and Watts (1953), above which a frictionless run-up has to lie.

**What to look at.** The run-up converges from above, at an order near 3 when cells and particles are refined together.
With six particles per cell side and ever finer cells an error of 0.7 % remains at $A = 0.3$, and one of 3 % at $A =
0.1$, where the same noise meets less energy. On 1:1 and 1:2 slopes the run-up is some 6 % above the measured one
(`cot_slope=2 amplitude=0.29`).

**Limits of this test.** The end of the tongue on a slope is thinner than a cell, and the run-up converges more slowly
there than at a wall.
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/record.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "seiche/exact/overturning/slope_runup.hpp"
#include "seiche/exact/overturning/wall_runup.hpp"
#include "seiche/exact/solitary_runup.hpp"
#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "seiche/models/gauss_particles/spline_space.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/solitary_climb.hpp"
#include "validation/studies/gauss_particles/gauss_frame.hpp"

namespace seiche::validation::cases::run_up_gauss {

// A solitary wave of the Euler equations climbs a plane slope or a wall, by free particles under Gauss's principle.
//
// Units: depth and gravity are 1, y counts from still water. The tank begins at x = 0. Wave, room behind it and way to
// the toe or the wall: at toe and end less than 0.4 % of the wave's height is cut off.

struct GaussClimb {
  exact::SolitaryWave wave;
  double cot_slope = 0;  ///< 0: a vertical wall
  long cells = 4;        ///< to a depth
  long per_cell = 12;    ///< particles to a cell's side

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(cells); }
  [[nodiscard]] double crest() const {
    constexpr double cut_off = 0.001;  // the tail is 4 exp(-k x) times the height, or less
    return std::ceil(-std::log(cut_off) / wave.decay_rate());
  }
  [[nodiscard]] double toe() const { return 2 * crest(); }
  /// b(x), with the corner at the toe rounded over a quarter of the depth on either side, so that b'' is continuous.
  [[nodiscard]] double bottom(double x) const;
  [[nodiscard]] double bottom_slope(double x) const;
  /// The run ends then at the latest.
  [[nodiscard]] double latest() const { return (crest() + 4 * cot_slope + 10) / wave.speed(); }
  [[nodiscard]] double tau() const { return (cot_slope == 0 ? 0.15 : 0.12) * spacing() / wave.speed(); }
  [[nodiscard]] gauss_particles::Flow start() const;
  /// "4 cells to a depth, 12 particles to a side".
  [[nodiscard]] std::string resolution() const {
    return fmt::format("{} cells per depth, {} particles per side", cells, per_cell);
  }
};

struct GaussClimbRun {
  double highest = 0;  ///< marker beyond the toe, or at the wall
  double time = 0;     ///< since the start
  bool fell = false;   ///< the water fell after that: it was the maximum
  std::vector<double> times, levels;
  GaussFrame at_highest, at_end;
  double energy_defect = 0;   ///< largest after booking what the penalty took, over the wave's energy
  double penalty_loss = 0;    ///< over the wave's energy
  double beyond = 0;          ///< farthest place of a particle behind bottom and walls, after any step
  double free_particles = 0;  ///< most of them in any step
  double particles = 0;

  /// NaN unless the water fell after its highest.
  [[nodiscard]] double runup() const { return fell ? highest : nan; }
};

using gauss_particles::LatticePlan;
using gauss_particles::SplineSpace;

constexpr double rounding = 0.25;  ///< half-length of the rounded toe
constexpr double markers_per_cell = 10;
constexpr double shown = 4;          ///< depths before the toe that frames show
constexpr double highest_place = 4;  ///< that the water may reach

std::size_t count(double number) {
  return static_cast<std::size_t>(std::lround(number));
}

/// How far the particles are behind bottom and walls.
double farthest_beyond(const gauss_particles::Flow& flow, const GaussClimb& climb) {
  Largest beyond;
  beyond.add(0);
  const std::size_t massive = flow.model().size() - flow.markers().size();
  for (std::size_t k = 0; k < massive; ++k) {
    const double x = flow.x()[k];
    beyond.add(climb.bottom(x) - flow.y()[k]);
    beyond.add(-x);
    if (climb.cot_slope == 0) beyond.add(x - climb.toe());
  }
  return beyond.value();
}

double GaussClimb::bottom(double x) const {
  const double z = (x - toe()) / rounding;
  if (cot_slope == 0 || z <= -1) return -1;
  if (z >= 1) return -1 + (x - toe()) / cot_slope;
  const double s = (z + 1) / 2;
  return -1 + 2 * rounding / cot_slope * s * s * s * s * (2.5 + s * (s - 3));
}

double GaussClimb::bottom_slope(double x) const {
  const double z = (x - toe()) / rounding;
  if (cot_slope == 0 || z <= -1) return 0;
  if (z >= 1) return 1 / cot_slope;
  const double s = (z + 1) / 2;
  return s * s * s * (10 + s * (6 * s - 15)) / cot_slope;
}

gauss_particles::Flow GaussClimb::start() const {
  const double end = toe() + cot_slope;
  const auto columns = static_cast<double>(cells) * end;
  LatticePlan plan{.cell_x = spacing(), .left_wall = 0.0, .bottom = true, .ground = {.level = -1}};
  if (cot_slope == 0) {
    plan.right_wall = end;
  } else {
    plan.ground = {.profile = std::make_shared<SmoothBottom>([of = *this](double x) { return of.bottom(x); },
                                                             [of = *this](double x) { return of.bottom_slope(x); }, -1,
                                                             toe() + (1 + highest_place) * cot_slope)};
  }
  const auto elevation = [this](double x) { return wave.elevation(x - crest()); };
  return gauss_particles::Flow(
      gauss_particles::layer({.end = end,
                              .columns = count(columns * static_cast<double>(per_cell)),
                              .rows = static_cast<std::size_t>(cells * per_cell),
                              .surface = [&](double x) { return std::max(elevation(x), bottom(x)); },
                              .bottom = [this](double x) { return bottom(x); },
                              .markers = count(columns * markers_per_cell),
                              .marker_at_end = true}),
      std::make_unique<SplineSpace>(plan, SplineSpace::Settings{.inner_fraction = 0.25}),
      [&](Point r) {
        if (cot_slope != 0 && r.x > toe() - rounding) return Point{0, 0};
        // The surface itself is the end of the exact field: points above it by rounding are put on it.
        const auto v = wave.velocity(r.x - crest(), std::min(r.y, elevation(r.x) - 1e-13));
        return Point{v.u, v.v};
      },
      {.gravity = 1, .penalty = 0.01});
}

/// Runs until the edge has fallen by 2 % of its highest.
GaussClimbRun climb(const GaussClimb& climb) {
  gauss_particles::Flow flow = climb.start();
  GaussClimbRun run;
  run.particles = static_cast<double>(flow.model().size() - flow.markers().size());
  const double wave_energy = climb.wave.kinetic_energy() + climb.wave.potential_energy();  // that the run begins with
  const double arrival = (climb.crest() - 3) / climb.wave.speed();
  const double edge = climb.cot_slope == 0 ? climb.toe() - climb.spacing() : climb.toe();
  Largest beyond;
  const auto shore = [&] {
    Largest level;
    for (const Point& marker : flow.markers()) {
      if (marker.x >= edge) level.add(marker.y);
    }
    return level.value();
  };
  while (!run.fell && flow.time() < climb.latest()) {
    flow.advance(climb.tau());
    flow.observe();
    beyond.add(farthest_beyond(flow, climb));
    run.times.push_back(flow.time());
    run.levels.push_back(shore());
    if (flow.time() < arrival) continue;
    if (run.levels.back() > run.highest) {
      run.highest = run.levels.back();
      run.time = flow.time();
      run.at_highest = GaussFrame(flow, climb.toe() - shown);
    }
    run.fell = run.highest > climb.wave.amplitude() && run.levels.back() < 0.98 * run.highest;
  }
  run.at_end = GaussFrame(flow, climb.toe() - shown);
  run.energy_defect = flow.ledger().largest_defect("energy") / wave_energy;
  run.penalty_loss = flow.model().penalty_loss() / wave_energy;
  run.beyond = beyond.value();
  run.free_particles = flow.most_free_particles();
  return run;
}

const std::string source = "Frank (1994), chapter 6; Su and Mirie (1980)";
const std::string experiment = "Hall and Watts (1953), in Frank (1994)";

GaussClimb climb_of(const Values& values) {
  const double cot_slope = values.real("cot_slope");
  if (cot_slope > 0 && cot_slope < 1) {
    throw std::invalid_argument(
        fmt::format("cot_slope = {:g} is out of range: must be 0 (a wall) or at least 1, because the toe is rounded "
                    "over half a depth",
                    cot_slope));
  }
  return {.wave = exact::SolitaryWave(values.real("amplitude")),
          .cot_slope = cot_slope,
          .cells = values.integer("cells"),
          .per_cell = values.integer("per_cell")};
}

/// Coarser lattices, in quarters of what was asked for.
constexpr long parts = 4;
bool has_coarser(const Values& values) {
  return values.integer("cells") % parts == 0 && values.integer("per_cell") % parts == 0;
}
struct Results {
  GaussClimb climb;
  GaussClimbRun finest;
  RunUpSequence lattices;  ///< the finest last
  double exact = nan;

  [[nodiscard]] double last_change() const { return lattices.height.back() / lattices.height.end()[-2] - 1; }
};

std::optional<double> tabled(const Values& values, const std::string& name, const std::string& column) {
  const double amplitude = values.real("amplitude");
  if (name == "wall_runup_exact") return entry_where(values.table(name), {{"a", amplitude}}, column);
  return entry_where(values.table(name), {{"A", amplitude}, {"cot_slope", values.real("cot_slope")}}, column);
}

std::optional<double> tabled_exact(const Values& values) {
  return tabled(values, values.real("cot_slope") == 0 ? "wall_runup_exact" : "slope_runup_exact", "R");
}

/// Whether the run-up of the Euler equations is known, by a table or by a computation.
bool is_known(const GaussClimb& climb) {
  const double amplitude = climb.wave.amplitude();
  if (climb.cot_slope == 0) return amplitude >= 0.05 && amplitude <= 0.6;
  return climb.cot_slope <= 3 && amplitude >= 0.02 && amplitude <= 0.5;
}

/// By the table of Hall and Watts' measurements, or else by their formula; none for other slopes.
std::optional<double> measured(const Values& values) {
  const double cot_slope = values.real("cot_slope");
  if (cot_slope == 0) return {};
  if (const auto found = tabled(values, "frank_1994_runup_hall_watts", "R_HW")) return found;
  return exact::HallWatts(1, 1 / cot_slope).runup(values.real("amplitude"));
}

void claim_method(const GaussClimb& climb, const Claims<GaussClimbRun>& claims) {
  claims.from("Frank (1994), chapter 6; exact for every space and step")
      .check(
          "energy", "The energy change equals the dissipation of the penalty, to round-off.",
          "largest energy error over the wave energy", &GaussClimbRun::energy_defect,
          Roundoff{
              .operations = std::ceil(climb.latest() / climb.tau()),
              .scale = 1,
              .reason = "one rounding per step of the kinetic and the potential energy, whose sum is the wave energy"});
  claims.from("Frank (1994), chapter 6")
      .check("loss",
             "The energy dissipated by the penalty is at most 0.15 % of the wave energy, equivalent to 0.1 % of the "
             "run-up.",
             "dissipated energy over the wave energy", &GaussClimbRun::penalty_loss,
             Bound{.limit = 0.0015,
                   .reason = "a tenth of the 1 % allowed for the last refinement; wave energy grows as height to the "
                             "power 3/2, run-up as height"});
  claims.from("Frank (1994), chapter 6; the fields are along the walls")
      .check(
          "contained",
          "The penetration of particles into bed or walls is at most g tau^2/2, the deviation of a straight step from "
          "their path.",
          "largest penetration over tau^2/2",
          [half = climb.tau() * climb.tau() / 2](const GaussClimbRun& run) { return run.beyond / half; },
          Bound{.limit = 1,
                .reason = "a straight step deviates from the path along a wall by tau^2/2 times the acceleration, "
                          "which is at most gravity there"});
}

void claims(const Values& values, const Claims<Results>& all) {
  const GaussClimb climb = climb_of(values);
  const double amplitude = climb.wave.amplitude();
  claim_method(climb, all.of(&Results::finest).at(climb.resolution()));
  const auto ladder = all.at(climb.resolution() + ", and two coarser grids")
                          .only_if(has_coarser(values), "coarser grids need multiples of 4");
  const std::optional<double> exact = tabled_exact(values);
  ladder.only_if(is_known(climb), "no exact value is available for this slope")
      .check(
          "exact", "Maximum run-up agrees with the Euler equations within the numerical uncertainty.", "run-up [depth]",
          [tabled = exact.has_value()](const Results& r) -> Measurement {
            Measurement runup{.value = r.lattices.height.back(), .uncertainty = r.lattices.limit().uncertainty};
            if (!tabled) runup.told.expected = r.exact;
            return runup;
          },
          Uncertainty{.expected = exact ? Amount(*exact) : Amount::told_by_run(4 * amplitude),
                      .data = 1.1e-5,
                      .useful = 0.05 * 2 * amplitude,
                      .reason = "numerical: from the change between grids, at most 5 % of 2 A; exact value to 1.1e-5, "
                                "computed where not tabulated; run-up below 4 A"});
  ladder.check(
      "converged",
      "The change of the run-up by the last refinement is at most 1 %, a fifth of the scatter of measurements.",
      "change by the last refinement, relative", &Results::last_change,
      Bound{.limit = 0.01, .reason = "a fifth of the scatter of measured run-up, 5 %"});
  const std::optional<double> expected = measured(values);
  all.at(climb.resolution())
      .only_if(expected.has_value(), "measurements exist for slopes only")
      .from(experiment)
      .check(
          "measurements",
          "The run-up lies 0 to 10 % above the measurement, as friction and two standard uncertainties of 5 % allow.",
          "R/R_measured - 1", [expected](const Results& r) { return r.finest.runup() / *expected - 1; },
          Bound{.limit = 0.05,
                .reason = "0 to 10 %: a frictionless run-up cannot lie below the measurement, and above it by at most "
                          "two standard uncertainties, 5 % each (assumed)",
                .expected = 0.05});
}

double computed_exact(const GaussClimb& climb) {
  const double amplitude = climb.wave.amplitude();
  if (climb.cot_slope > 0) return exact::SlopeRunup(amplitude, climb.cot_slope).runup();
  constexpr std::size_t markers = 256;
  return exact::WallRunup(amplitude, 1, markers).runup();
}

Results compute(const Run& run) {
  Results r{.climb = climb_of(run)};
  if (has_coarser(run)) {
    for (const long part : {2L, 3L}) {
      GaussClimb coarser = r.climb;
      coarser.cells = coarser.cells * part / parts;
      coarser.per_cell = coarser.per_cell * part / parts;
      r.lattices.add(coarser.spacing(), climb(coarser).runup());
      run.progress(part == 2 ? 0.05 : 0.3);
    }
  }
  r.finest = climb(r.climb);
  r.lattices.add(r.climb.spacing(), r.finest.runup());
  if (is_known(r.climb)) {
    const auto known = tabled_exact(run);
    r.exact = known ? *known : computed_exact(r.climb);
  }
  return r;
}

void draw(const Results& r, evidence::Exhibit& exhibit) {
  const GaussClimbRun& run = r.finest;
  auto& water =
      exhibit.figure("water", "The water at the shore",
                     fmt::format("Surface markers; A = {:g}; {}.", r.climb.wave.amplitude(), r.climb.resolution()));
  for (const GaussFrame* frame : {&run.at_highest, &run.at_end}) {
    auto& panel = water.panel(
        {.x = "x [depth]", .y = "y [depth]", .title = fmt::format("t = {:.2f}", frame->time), .equal_aspect = true});
    const std::vector<double> x =
        evenly(frame->line_x.front(), r.climb.toe() + r.climb.cot_slope * (1 + run.highest), 201);
    panel.line("bottom", x, each(x, [&](double at) { return r.climb.bottom(at); }), Role::bed);
    panel.line("surface", frame->line_x, frame->line_y, Role::computed);
  }
  auto& history = add_panel(exhibit, "history", "Level at the shore", "Highest marker beyond the toe, or at the wall.",
                            {.x = "t [sqrt(depth/g)]", .y = "level [depth]"});
  history.line("particles", run.times, run.levels, Role::computed);
  const std::vector<double> ends{run.times.front(), run.times.back()};
  if (!std::isnan(r.exact)) history.line("exact run-up", ends, std::vector<double>(2, r.exact), Role::exact);
}

void draw_convergence(const Results& r, evidence::Exhibit& exhibit) {
  exhibit.measure("runup_extrapolated", r.lattices.limit().extrapolated);
  auto& figure = exhibit.figure("convergence", "Convergence of the run-up",
                                "Cells and particles per cell side are refined together.");
  if (std::isnan(r.exact)) {
    figure.panel({.x = "h [depth]", .y = "R [depth]"})
        .points("particles", r.lattices.spacing, r.lattices.height, Role::computed);
    return;
  }
  const std::vector<double> errors = each(r.lattices.height, [&](double runup) { return std::abs(runup - r.exact); });
  auto& panel = figure.panel({.x = "h [depth]", .y = "|R - R_exact| [depth]", .log_x = true, .log_y = true});
  panel.points("particles", r.lattices.spacing, errors, Role::computed);
  slope_guide(panel, 2, r.lattices.spacing, errors.back());
}

void show(const Results& r, const Values& values, evidence::Exhibit& exhibit) {
  exhibit.measure("runup", r.finest.runup());
  exhibit.measure("time_of_maximum", r.finest.time);
  exhibit.measure("particles", r.finest.particles);
  exhibit.measure("free_particles", r.finest.free_particles);
  if (!std::isnan(r.exact) && r.climb.cot_slope == 0) {
    exhibit.measure("su_mirie", exact::WallRunup::su_mirie(r.climb.wave.amplitude()));
  }
  if (const auto found = measured(values)) exhibit.measure("runup_measured", *found);
  if (r.climb.cot_slope != 0) {
    const auto mesh = tabled(values, "frank_1994_runup", "R_calc");
    if (mesh) exhibit.measure("runup_mesh_in_thesis", *mesh);
    exhibit.measure("runup_law", runup_law(r.climb.cot_slope, r.climb.wave.amplitude()));
  }
  draw(r, exhibit);
  if (r.lattices.spacing.size() > 2) draw_convergence(r, exhibit);
  r.finest.at_highest.add_to(exhibit, "depth");
  r.finest.at_end.add_to(exhibit, "depth");
}

void run_up_gauss(Case& c) {
  c.title = "Run-up of a solitary wave on a wall or a slope: Gauss-principle particles";
  c.source = literature::frank + ", chapters 3 and 6; " + literature::su_mirie + "; " + literature::hall_watts;
  c.parameters = {
      real("amplitude", 0.3, "depth", {0.05, 0.6}, "height of the incident wave"),
      real("cot_slope", 0.0, "1", {0, 5}, "s of the slope 1:s, 1 or more; 0: a vertical wall"),
      integer("cells", {4, 8, 8}, {2, 40}, "cells per depth"),
      integer("per_cell", {12, 16, 16}, {6, 40}, "particles per cell side"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::run_up_gauss
