/*
A solitary wave runs against a vertical wall and climbs it, on Frank's two-dimensional Lagrangian mesh. The exact run-up
of the Euler equations is known to many digits (`wall_run_up_exact`).

**Set-up.** Depth, gravity and density are 1. The exact solitary wave, with its velocities, starts at a distance of 12
from the wall, in a tank 24 long. The last column of nodes slides up and down the wall: its top is the contact point,
and the adjacent cells give the pressure. Pressures are means over two steps; $y = 0$ is the still-water level.

**What is compared.** Run-up and loads with their exact values, on the requested mesh and on coarser ones, refining
columns, rows and steps together; the change from mesh to mesh gives their uncertainty.

**What to look at.** The run-up converges from below, at an order between 1.5 and 2 that rises with the resolution; so
does the force, and the bed pressure at order 2. The pressure at $y = 0$ is interpolated between two cells whose
position at the wall changes from mesh to mesh: it is as accurate, but does not follow a power of the cell size. The
force of a high wave has two maxima: at the time of the highest level the water accelerates downwards, and the pressure
is below hydrostatic. The mesh at the maximum run-up: columns at the wall become tall and thin. Above $A = 0.45$ they
may tangle when the water falls again; the case then reports time and position (`wall_run_up_mesh_limit`), unless the
mesh is rezoned (`rezone`, `run_up_mesh_rezoned`).
*/
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "seiche/exact/overturning/wall_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/mesh_climb.hpp"
#include "validation/run_up/solitary_climb.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::wall_run_up_mesh {

const std::string source = "Frank (1994), chapter 2; Su and Mirie (1980)";

MeshClimb climb_of(const Values& values) {
  MeshClimb climb = mesh_climb_from(values, exact::SolitaryWave(values.real("amplitude")));
  climb.rezone = values.real("rezone");
  return climb;
}

/// Coarser meshes, in eighths of the rows, columns and steps that were asked for.
constexpr long parts = 8;
bool has_coarser(const Values& values) {
  return values.integer("rows") % parts == 0;
}

/// Exact values end there.
bool has_exact(double amplitude) {
  return amplitude >= 0.05 && amplitude <= 0.6;
}

std::optional<double> tabled_runup(const Values& values) {
  return entry_where(values.table("wall_runup_exact"), {{"a", values.real("amplitude")}}, "R");
}

/// What the meshes give, the one that was asked for last; NaN where one tangles before its largest run-up.
struct Sequence {
  std::vector<double> spacing;
  std::vector<ClimbMaxima> maxima;

  void add(const MeshClimb& climb, const MeshRun& run) {
    spacing.push_back(climb.spacing);
    maxima.push_back(run.reached());
  }
  /// That all meshes carried the wave to its largest run-up.
  [[nodiscard]] bool complete() const { return !std::isnan(worst(each(maxima, &ClimbMaxima::level))); }
  [[nodiscard]] evidence::GridConvergence limit(double ClimbMaxima::*of) const {
    return evidence::grid_convergence(spacing, each(maxima, of), 2);
  }
  [[nodiscard]] Measurement finest(double ClimbMaxima::*of) const {
    return {.value = maxima.back().*of, .uncertainty = limit(of).uncertainty};
  }
  [[nodiscard]] std::vector<double> errors(double ClimbMaxima::*of, double exact) const {
    return each(maxima, [&](const ClimbMaxima& one) { return std::abs(one.*of - exact); });
  }
};

struct Results {
  MeshClimb climb;
  MeshRun up;
  Sequence all;
  double exact;  ///< NaN where it is not known
  bool tabled;   ///< known beforehand
};

void claim_holds(const MeshClimb& climb, const Claims<Results>& claims) {
  // A little lower it depends on the mesh.
  constexpr double tangling = 0.48;
  claims
      .fails({.value = 0,
              .width = 0,
              .reason =
                  fmt::format("from A = {:g} on the thin column at the wall collapses when the water falls", tangling)},
             climb.wave.amplitude() >= tangling && climb.settings.hourglass == 0 && climb.rezone == 0)
      .check(
          "holds", "The mesh remains untangled until the wave has left the wall.", "it does",
          [](const Results& r) -> Measurement {
            if (!r.up.tangle) return {.value = 1};
            return {.value = 0, .where = r.up.tangle->where()};
          },
          Qualitative{.detector = "no cell corner inverts",
                      .reason = "the Euler equations have a solution to the end"});
}

Order second_order(const MeshClimb& climb) {
  constexpr double coarsest_judged = 0.25;
  return {
      .theory = 2,
      .tolerance = 2 * std::min(climb.spacing, coarsest_judged),
      .reason =
          "areas, pressure and surface shape are second-order; nodes move along the surface with first-order errors, "
          "so that the next term is smaller by a factor h1 only: 2 h1 for the finest mesh, and no more than 0.5"};
}

/// Of the largest loads, where a table has exact values for the wave.
void claim_loads(const Values& values, const MeshClimb& climb, const Claims<Results>& claims) {
  const io::Table table = values.table("wall_load_exact");
  const double amplitude = climb.wave.amplitude();
  const bool mesh_holds = amplitude < 0.55 || climb.rezone > 0;
  const auto row = mesh_holds ? row_where(table, {{"A", amplitude}}) : std::nullopt;
  const auto known =
      claims
          .only_if(row.has_value(),
                   "exact loads are tabulated for A = 0.05, 0.1, ... 0.6; from 0.55 on only a rezoned mesh lasts")
          .only_if(has_coarser(values), "coarser meshes need a number of rows that is a multiple of 8");
  for (const LoadMaximum& load : load_maxima) {
    const double exact = row ? table.column(load.column)[*row] : 0;
    known.at(fmt::format("{}, and 4 coarser meshes", climb.resolution()))
        .check(
            "load-" + load.id,
            fmt::format("The maximum {} agrees with the Euler equations within the mesh uncertainty.", load.name),
            fmt::format("{} [{}]", load.name, load.unit), [load](const Results& r) { return r.all.finest(load.of); },
            Uncertainty{
                .expected = exact,
                .data = 1e-10,
                .useful = 0.05 * exact,
                .reason = "numerical: from the change between meshes, at most 5 % of the load; exact value to 1e-10"});
    if (!load.converges) continue;
    known.check(
        "load-" + load.id + "-order",
        fmt::format("The maximum {} converges to the Euler equations at second order.", load.name),
        "order in the cell size",
        [load, exact](const Results& r) {
          return evidence::observed_order(r.all.spacing, r.all.errors(load.of, exact));
        },
        second_order(climb));
  }
}

void claims(const Values& values, const Claims<Results>& claims) {
  const MeshClimb climb = climb_of(values);
  const double amplitude = climb.wave.amplitude();
  claim_holds(climb, claims.at(climb.resolution()));
  const auto known = claims.only_if(has_exact(amplitude), "exact values exist for A = 0.05 to 0.6")
                         .only_if(has_coarser(values), "coarser meshes need a number of rows that is a multiple of 8");
  const std::optional<double> tabled = tabled_runup(values);
  known.at(fmt::format("{}, and 4 coarser meshes", climb.resolution()))
      .check(
          "exact", "Maximum run-up agrees with the Euler equations within the numerical uncertainty.", "run-up [depth]",
          [](const Results& r) -> Measurement {
            if (!r.all.complete()) throw std::runtime_error("a mesh tangles before its maximum run-up");
            Measurement runup = r.all.finest(&ClimbMaxima::level);
            if (!r.tabled) runup.told.expected = r.exact;
            return runup;
          },
          Uncertainty{.expected = tabled ? Amount(*tabled) : Amount::told_by_run(3 * amplitude),
                      .data = 1.1e-5,
                      .useful = 0.05 * 2 * amplitude,
                      .reason = "numerical: from the change between meshes, at most 5 % of 2 A; exact value to 1.1e-5, "
                                "computed where not tabulated; run-up below 3 A up to A = 0.6"});
  known.check(
      "order", "Maximum run-up converges to the Euler equations at second order.", "order in the cell size",
      [](const Results& r) {
        return evidence::observed_order(r.all.spacing, r.all.errors(&ClimbMaxima::level, r.exact));
      },
      second_order(climb));
  claim_loads(values, climb, claims);
}

Results compute(const Run& run) {
  const MeshClimb climb = climb_of(run);
  MeshRun up = climb_on_mesh(climb);
  run.progress(0.5);
  Sequence all;
  if (has_coarser(run)) {
    for (const long part : {2, 3, 4, 6}) {
      const MeshClimb coarser = climb.refined(static_cast<double>(part) / parts);
      all.add(coarser, climb_on_mesh(coarser));
      run.progress(0.5 + 0.08 * static_cast<double>(part));
    }
    all.add(climb, up);
  }
  const std::optional<double> tabled = tabled_runup(run);
  double exact = nan;
  if (tabled) {
    exact = *tabled;
  } else if (has_exact(climb.wave.amplitude())) {
    constexpr std::size_t markers = 256;
    exact = exact::WallRunup(climb.wave.amplitude(), 1, markers).runup();
  }
  return {climb, std::move(up), std::move(all), exact, tabled.has_value()};
}

void draw_wall(const MeshClimb& climb, const MeshRun& up, evidence::Exhibit& exhibit) {
  if (up.times.empty()) return;  // tangled in its first step
  auto& histories = exhibit.figure("wall", "Water level and load at the wall",
                                   fmt::format("A = {:g}; {}.", climb.wave.amplitude(), climb.resolution()));
  histories.panel({.x = "t [sqrt(depth/g)]", .y = "contact point [depth]"}).line("mesh", up.times, up.levels);
  const std::vector<double> time = each(up.loads, &WallLoad::time);
  const auto pressure_at = [&](double y) {
    return each(up.loads, [y](const WallLoad& load) { return load.pressure_at(y); });
  };
  auto& pressures = histories.panel({.x = "t [sqrt(depth/g)]", .y = "pressure [rho g depth]"});
  pressures.line("at the bottom", time, pressure_at(-1));
  pressures.line("at y = 0", time, pressure_at(0), Role::peer);
  histories.panel({.x = "t [sqrt(depth/g)]", .y = "force [rho g depth^2]"})
      .line("mesh", time, each(up.loads, &WallLoad::force));

  const MeshWindow window{.begin = -2.5, .end = 0};
  auto& meshes = exhibit.figure("mesh", "The mesh at the wall",
                                up.tangle ? "At the maximum run-up, and before the step in which it tangles."
                                          : "At the maximum run-up, and at the end.");
  auto& highest = meshes.panel(mesh_axes(fmt::format("t = {:.2f}", up.time_of_highest), window));
  draw_mesh(highest, "mesh", up.flow.model().mesh(), up.x, up.y, window);
  auto& last = meshes.panel(mesh_axes(fmt::format("t = {:.2f}", up.flow.time()), window));
  draw_mesh(last, "mesh", up.flow, window);
}

void show_convergence(const Results& r, evidence::Exhibit& exhibit) {
  exhibit.measure("runup_extrapolated", r.all.limit(&ClimbMaxima::level).extrapolated);
  if (std::isnan(r.exact)) return;
  const double amplitude = r.climb.wave.amplitude();
  exhibit.measure("su_mirie", exact::WallRunup::su_mirie(amplitude));
  auto& panel = add_panel(exhibit, "convergence", "Convergence of the run-up",
                          fmt::format("A = {:g}, exact value {:.6f}.", amplitude, r.exact),
                          {.x = "h1 [depth]", .y = "|R - R_exact| [depth]", .log_x = true, .log_y = true});
  const std::vector<double> error = r.all.errors(&ClimbMaxima::level, r.exact);
  panel.points("mesh", r.all.spacing, error, Role::computed);
  slope_guide(panel, 2, r.all.spacing, error.back());
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const MeshRun& up = r.up;
  exhibit.measure("highest", up.highest.level);
  if (up.fell) exhibit.measure("runup", up.runup());
  exhibit.measure("time_of_maximum", up.time_of_highest);
  exhibit.measure("pressure_still_water_level", up.highest.still);
  exhibit.measure("pressure_bottom", up.highest.bottom);
  exhibit.measure("force", up.highest.force);
  exhibit.measure("worst_corner_at_runup", up.worst_shape.value());
  if (up.tangle) {
    exhibit.measure("tangle_time", up.tangle->time);
    exhibit.measure("tangle_place", up.tangle->place);
  }
  draw_wall(r.climb, up, exhibit);
  if (!r.all.spacing.empty() && r.all.complete()) show_convergence(r, exhibit);
}

void wall_run_up_mesh(Case& c) {
  c.former_names = {"wall_run_up_2d"};
  c.title = "Run-up of a solitary wave on a vertical wall: two-dimensional Lagrangian mesh";
  c.source = literature::frank + ", section 2.2, figures 2 and 3; " + literature::su_mirie;
  c.parameters = joined(
      {{real("amplitude", 0.3, "depth", {0.02, 0.8}, "height of the incident wave")},
       mesh_parameters({0.25, 0.125, 0.125}, {8, 16, 16}, {0.025, 0.0125, 0.0125}),
       {real("rezone", 0, "cells", {0, 0.5},
             "largest deviation of a node from its position before rezoning; 0: no rezoning, as in Frank's model")}});
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wall_run_up_mesh
