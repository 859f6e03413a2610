/*
A solitary wave runs against a vertical wall and climbs it, on Frank's two-dimensional Lagrangian mesh. The exact run-up
of the Euler equations is known to many digits (`wall_run_up_exact`), so that the mesh can be judged by the truth.

**Set-up.** Depth, gravity and density are 1. The exact solitary wave starts 12 depths from the wall, with its own
velocities, in a tank of 24 depths. The last column of nodes slides up and down the wall: its top is the contact point,
and the cells beside it give the pressure. Pressures are means over two steps; $y = 0$ is the still-water level.

**What is compared.** The run-up with the exact value, on the mesh that was asked for and on coarser ones, columns, rows
and steps together. The energy of the run. The loads have no exact values here: they come with the uncertainty that
their change from mesh to mesh gives.

**What to look at.** The run-up converges from below, with an order between 1.5 and 2 that rises with the resolution.
The force of a high wave has two humps: while the water at the wall is highest it accelerates downwards, and the
pressure is less than its depth suggests. The mesh at the largest run-up: columns at the wall become tall and thin.
Above $A = 0.45$ they may fold when the water falls again; the case then tells when and where (`wall_run_up_mesh_limit`).
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/exact/wall_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"
#include "validation/run_up/mesh_wall_climb.hpp"
#include "reports/evidence/slope_guide.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;
using lagrangian_mesh_2d::Flow;

const std::string source = "Frank (1994), chapter 2; Su and Mirie (1980)";

struct History {
  std::vector<double> time, contact, load_time, still, bottom, force;
  std::vector<double> highest_x, highest_y;  ///< the mesh when the contact point was highest

  void add(const Flow& flow) {
    const double now = flow.surface_y().back();
    if (contact.empty() || now > *std::max_element(contact.begin(), contact.end())) {
      highest_x.assign(flow.x().begin(), flow.x().end());
      highest_y.assign(flow.y().begin(), flow.y().end());
    }
    time.push_back(flow.time());
    contact.push_back(now);
    if (flow.steps() < 2) return;
    const auto load = flow.wall_load(Flow::WallSide::right);
    load_time.push_back(load.time);
    still.push_back(load.pressure_at(0));
    bottom.push_back(load.pressure_at(-1));
    force.push_back(load.force);
  }
};

void draw(evidence::Record& record, const MeshWallClimb& climb, const History& all, const MeshWallRun& run) {
  auto& histories = record.figure("wall", "Water level and load at the wall",
                                  fmt::format("A = {:g}; {}.", climb.wave.amplitude(), climb.resolution()));
  histories.panel({.x = "t [sqrt(depth/g)]", .y = "contact point [depth]"}).line("mesh", all.time, all.contact);
  auto& pressures = histories.panel({.x = "t [sqrt(depth/g)]", .y = "pressure [rho g depth]"});
  pressures.line("at the bottom", all.load_time, all.bottom);
  pressures.line("at y = 0", all.load_time, all.still, Role::peer);
  histories.panel({.x = "t [sqrt(depth/g)]", .y = "force [rho g depth^2]"}).line("mesh", all.load_time, all.force);

  const MeshWindow window{.begin = -2.5, .end = 0};
  auto& meshes = record.figure("mesh", "The mesh at the wall",
                               run.fold ? "At the largest run-up, and before the step in which it folds."
                                        : "At the largest run-up, and at the end.");
  auto& highest = meshes.panel(mesh_axes(fmt::format("t = {:.2f}", run.time_of_runup), window));
  draw_mesh(highest, "mesh", run.flow.model().mesh(), all.highest_x, all.highest_y, window);
  auto& last = meshes.panel(mesh_axes(fmt::format("t = {:.2f}", run.flow.time()), window));
  draw_mesh(last, "mesh", run.flow, window);
}

/// From the table of exact values where it is there, or computed.
double exact_runup(double amplitude, evidence::Record& record) {
  const io::Table table = reference_table("wall_runup_exact", record.reference_data);
  for (std::size_t k = 0; k < table.column("a").size(); ++k) {
    if (std::abs(table.column("a")[k] - amplitude) < 1e-12) return table.column("R")[k];
  }
  constexpr std::size_t markers = 256;
  return exact::WallRunup(amplitude, 1, markers).runup();
}

void claim_energy(evidence::Record& record, const MeshWallClimb& climb, const MeshWallRun& run) {
  const evidence::Claim claim{.id = "energy",
                              .text = "Energy is kept while the wave climbs.",
                              .quantity = "largest change over the energy of the wave",
                              .source = "Frank (1994), section 1.2"};
  const evidence::Measurement measured{.value = run.energy_defect, .resolution = climb.resolution()};
  if (climb.stepping == mechanics::Stepping::conservative) {
    record.check(claim, measured,
                 evidence::Roundoff{
                     .operations = static_cast<double>(run.flow.steps()) + static_cast<double>(run.flow.x().size()),
                     .reason = "discrete gradients are exact: one rounded energy per step, summed over "
                               "the nodes"});
    return;
  }
  const double rate = climb.wave.speed() * climb.wave.decay_rate();
  record.check(claim, measured,
               evidence::Bound{.limit = std::pow(rate * climb.tau, 2) / 4,
                               .reason = "Verlet's energy of a mode oscillates by (omega tau)^2/4; omega is the rate "
                                         "at which the wave rises at a place, its speed times its tail's decay"});
}

void claim_holds(evidence::Record& record, const MeshWallClimb& climb, const MeshWallRun& run) {
  const evidence::Claim claim{.id = "holds",
                              .text = "The mesh holds until the wave has left the wall.",
                              .quantity = "it does",
                              .source = source};
  const evidence::Measurement measured{.value = run.fold ? 0.0 : 1.0, .resolution = climb.resolution()};
  const evidence::Qualitative holds{.detector = "no corner of a cell folds",
                                    .reason = "below A = 0.45 all particles at the surface keep their neighbours"};
  constexpr double limit = 0.45;
  if (run.fold && climb.wave.amplitude() > limit) {
    record.known_failure(claim, measured, holds,
                         fmt::format("above A = {:g} the thin column at the wall collapses when the water falls: {}",
                                     limit, run.fold->what));
  } else {
    record.check(claim, measured, holds);
  }
}

struct Sequence {
  std::vector<double> spacing, runup, still, bottom, force;

  void add(const MeshWallClimb& climb, const MeshWallRun& run) {
    spacing.push_back(climb.spacing);
    runup.push_back(run.runup);
    still.push_back(run.pressure_still);
    bottom.push_back(run.pressure_bottom);
    force.push_back(run.force);
  }
};

void claim_convergence(evidence::Record& record, const MeshWallClimb& climb, const Sequence& all) {
  const evidence::GridConvergence limit = evidence::grid_convergence(all.spacing, all.runup, 2);
  record.measure("runup_extrapolated", limit.extrapolated);
  record.measure("runup_uncertainty", limit.uncertainty);
  record.measure("pressure_still_uncertainty", evidence::grid_convergence(all.spacing, all.still, 2).uncertainty);
  record.measure("pressure_bottom_uncertainty", evidence::grid_convergence(all.spacing, all.bottom, 2).uncertainty);
  record.measure("force_uncertainty", evidence::grid_convergence(all.spacing, all.force, 2).uncertainty);
  constexpr double lowest = 0.05;  // exact values end there
  constexpr double highest = 0.6;
  if (climb.wave.amplitude() < lowest || climb.wave.amplitude() > highest) return;
  const double exact = exact_runup(climb.wave.amplitude(), record);
  std::vector<double> error;
  for (const double runup : all.runup) error.push_back(std::abs(runup - exact));
  record.measure("runup_exact", exact);
  record.measure("su_mirie", exact::WallRunup::su_mirie(climb.wave.amplitude()));
  record.measure("runup_error", all.runup.back() - exact);
  record.check({.id = "exact",
                .text = "The run-up is that of the Euler equations.",
                .quantity = "run-up",
                .unit = "depth",
                .source = source},
               {.value = all.runup.back(),
                .uncertainty = limit.uncertainty,
                .resolution = fmt::format("{}, and {} coarser meshes", climb.resolution(), all.spacing.size() - 1)},
               evidence::Uncertainty{.expected = exact,
                                     .data = 1.1e-5,
                                     .useful = 0.05 * exact,
                                     .reason = "from the change from mesh to mesh; the exact value to 1.1e-5"});
  record.check({.id = "order",
                .text = "The run-up converges to it with order 2.",
                .quantity = "order in the size of the cells",
                .source = source},
               evidence::observed_order(all.spacing, error),
               evidence::Order{.theory = 2,
                               .tolerance = 2 * climb.spacing,
                               .reason = "areas, pressure and the surface's shape are of order 2; nodes move along "
                                         "the surface with errors of order 1, so that the next term is smaller by a "
                                         "factor h1 only: 2 h1 for the finest mesh"});
  auto& figure = record.figure("convergence", "Convergence of the run-up",
                               fmt::format("A = {:g}, exact value {:.6f}.", climb.wave.amplitude(), exact));
  auto& panel = figure.panel({.x = "h1 [depth]", .y = "|R - R_exact| [depth]", .log_x = true, .log_y = true});
  panel.points("mesh", all.spacing, error, Role::computed);
  slope_guide(panel, 2, all.spacing, error.back());
}

void converge(Running& run, const MeshWallClimb& climb, const MeshWallRun& finest) {
  constexpr long parts = 8;
  if (climb.rows % parts != 0 || !finest.fell) return;
  Sequence all;
  for (const long part : {2, 3, 4, 6}) {
    const MeshWallClimb coarser = climb.refined(static_cast<double>(part) / parts);
    const MeshWallRun one = climb_wall(coarser);
    if (one.fell) all.add(coarser, one);
    run.progress(0.5 + 0.08 * static_cast<double>(part));
  }
  all.add(climb, finest);
  constexpr std::size_t enough = 3;
  if (all.spacing.size() >= enough) claim_convergence(run.record, climb, all);
}

void run(Running& run) {
  const MeshWallClimb climb = mesh_climb_from(run.values(), exact::SolitaryWave(run.real("amplitude")));
  History history;
  const MeshWallRun up = climb_wall(climb, [&](const Flow& flow) { history.add(flow); });
  run.record.measure("runup", up.runup);
  run.record.measure("time_of_maximum", up.time_of_runup);
  run.record.measure("pressure_still_water_level", up.pressure_still);
  run.record.measure("pressure_bottom", up.pressure_bottom);
  run.record.measure("force", up.force);
  run.record.measure("worst_corner_at_runup", up.worst_shape);
  run.record.measure("energy_defect", up.energy_defect);
  if (up.fold) {
    run.record.measure("fold_time", up.fold->time);
    run.record.measure("fold_place", up.fold->place);
  }
  claim_energy(run.record, climb, up);
  claim_holds(run.record, climb, up);
  draw(run.record, climb, history, up);
  run.progress(0.5);
  converge(run, climb, up);
}

}  // namespace

Case wall_run_up_mesh() {
  Case c;
  c.former_names = {"wall_run_up_2d"};
  c.title = "A solitary wave climbs a vertical wall on the two-dimensional Lagrangian mesh";
  c.source =
      "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 2.2, figures 2 and 3; "
      "C. H. Su, R. M. Mirie, J. Fluid Mech. 98 (1980) 509";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = mesh_parameters({0.25, 0.125, 0.125}, {8, 16, 16}, {0.025, 0.0125, 0.0125});
  c.parameters.insert(c.parameters.begin(),
                      real("amplitude", 0.3, "depth", {0.02, 0.8}, "height of the incident wave"));
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
