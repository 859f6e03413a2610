/*
High solitary waves climb a vertical wall and steep slopes on the two-dimensional Lagrangian mesh with rezoned columns.

In Frank's own model surface nodes move ahead of the water beneath, crowd in the sheet at the wall and invert their
cells (`wall_run_up_mesh_limit`); at the toe of a slope bed nodes pass the corner (`slope_run_up_mesh`). The flow itself
is regular: below $A = 0.6$ its surface elevation is single-valued. The mesh is therefore rezoned: a tilted column
becomes the straight line through which the net flux is zero, its nodes return to their fractions of its length, and the
transported quantities are remapped.

**Set-up.** As in `wall_run_up_mesh` and `slope_run_up_mesh`: depth, gravity and density are 1, the crest of the exact
solitary wave starts at a distance of 12 from wall or toe, columns are twice as wide as rows are high. The mesh is
rezoned when a node deviates from its position by more than a fifth of its cell.

**What is compared.** The run-up with the exact values of the Euler equations (`seiche exact wall_runup`,
`slope_runup`), on four meshes; whether the mesh lasts to the end; the energy, with the booked loss of rezoning. Loads
on the wall are compared in `wall_run_up_mesh_figures`.

**What to look at.** No cell tangles, neither at the wall for $A = 0.6$, where Frank's mesh does not reach the run-up,
nor at the toe. Eight rows are 5 % low at $A = 0.6$ and 2 % at $A = 0.5$; at the wall the error converges at second
order as without rezoning, on slopes at first. Rezoning takes less than 0.1 % of the energy, at the wall half of it
while the sheet falls.
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "reports/evidence/slope_guide.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/mesh_climb.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::run_up_mesh_rezoned {

using lagrangian_mesh_2d::Flow;

const std::string source = "C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227";

/// Cells of the meshes, in eighths of the rows that were asked for.
constexpr std::array<long, 4> parts{4, 5, 6, 8};

/// Rows from which on the meshes tell an order, and the run-up on a slope of tangent 0.5: the coarsest has eight then.
constexpr long fine = 16;

struct Climb {
  double cot_slope;  ///< 0: the wall
  double amplitude;

  [[nodiscard]] bool wall() const { return cot_slope == 0; }
  [[nodiscard]] std::string id() const {
    const auto hundredths = std::lround(100 * amplitude);
    return wall() ? fmt::format("wall-{}", hundredths) : fmt::format("cot-{:g}-{}", cot_slope, hundredths);
  }
  [[nodiscard]] std::string title() const {
    return wall() ? fmt::format("A = {:g}, vertical wall", amplitude)
                  : fmt::format("A = {:g}, slope {:g}", amplitude, 1 / cot_slope);
  }
  /// Of the error in the size of the cells.
  [[nodiscard]] double order() const { return wall() ? 2 : 1; }
};
constexpr std::array<Climb, 6> climbs{{{0, 0.5}, {0, 0.6}, {1, 0.41}, {1, 0.5}, {2, 0.41}, {2, 0.5}}};

/// One wave on one mesh.
struct Reached {
  double spacing = 0;
  double runup = 0;  ///< NaN unless the water fell after it
  bool tangled = false;
  Worst unbooked;            ///< change of the energy less what rezoning took, over the wave's energy
  double taken = 0;          ///< by rezoning, over the wave's energy
  double rezoned = 0;        ///< times
  std::vector<double> x, y;  ///< of the nodes at the largest run-up
};

struct Climbed {
  Climb climb;
  std::vector<Reached> on = {};  ///< the meshes, from coarse to fine

  [[nodiscard]] std::vector<double> spacings() const { return each(on, &Reached::spacing); }
};
using Results = std::vector<Climbed>;

double exact_runup(const Values& values, const Climb& climb) {
  const auto found = climb.wall() ? entry_where(values.table("wall_runup_exact"), {{"a", climb.amplitude}}, "R")
                                  : entry_where(values.table("slope_runup_exact"),
                                                {{"A", climb.amplitude}, {"cot_slope", climb.cot_slope}}, "R");
  return found.value_or(nan);
}

std::string resolution(long rows) {
  return fmt::format("h1 = {:g}, {} rows", 2 / static_cast<double>(rows), rows);
}

void claim_whole(const Climb& climb, const Claims<Climbed>& claims) {
  claims.check(
      "whole-" + climb.id(),
      fmt::format("The mesh remains untangled {1} ({0}).", climb.title(),
                  climb.wall() ? "until the wave has left the wall" : "until the water has fallen"),
      "meshes that tangle",
      [](const Climbed& all) {
        return std::ranges::count_if(all.on, [](const Reached& one) { return one.tangled || std::isnan(one.runup); });
      },
      Bound{.limit = 0, .reason = "zero: the Euler equations have a solution to the end"});
}

void claim_runup(const Climb& climb, double exact, long rows, const Claims<Climbed>& claims) {
  claims.only_if(climb.cot_slope < 2 || rows >= fine, "fewer than 16 rows are inconclusive on a 1:2 slope")
      .check(
          "exact-" + climb.id(),
          fmt::format("The run-up agrees with the Euler equations within the mesh uncertainty ({}).", climb.title()),
          "run-up [depth]",
          [](const Climbed& all) -> Measurement {
            const std::vector<double> runup = each(all.on, &Reached::runup);
            return {.value = runup.back(),
                    .uncertainty = evidence::grid_convergence(all.spacings(), runup, all.climb.order()).uncertainty};
          },
          Uncertainty{.expected = exact,
                      .data = 1e-6,
                      .useful = 0.1 * exact,
                      .reason = "numerical: from the change between meshes, at most 10 % of the run-up; exact value to "
                                "seven digits"});
  claims.only_if(rows >= fine, "four rows are too few for an order: needs 16 rows or more")
      .check(
          "order-" + climb.id(),
          fmt::format("The run-up converges to the Euler equations at order {1:g} ({0}).", climb.title(),
                      climb.order()),
          "order in the cell size",
          [exact](const Climbed& all) {
            const auto error = [exact](const Reached& one) { return std::abs(one.runup - exact); };
            return evidence::observed_order(all.spacings(), each(all.on, error));
          },
          Order{
              .theory = climb.order(),
              .tolerance = 0.5,
              .reason =
                  "as without rezoning; at the wall nodes move along the surface with first-order errors, so that the "
                  "next term is smaller by a factor h1 only: 2 h1 for the coarsest of these meshes, half an order"});
}

void claim_energy(const Climb& climb, double tau, const Claims<Climbed>& claims) {
  const exact::SolitaryWave wave(climb.amplitude);
  claims.from("Frank (1994), section 1.2")
      .where("t = {:.2f}")
      .check(
          "energy-" + climb.id(),
          fmt::format("The energy change equals the recorded loss by rezoning within (omega tau)^2/4 ({}).",
                      climb.title()),
          "largest unrecorded energy change over the wave energy",
          [](const Climbed& all) { return all.on.back().unbooked; },
          Bound{.limit = std::pow(wave.speed() * wave.decay_rate() * tau, 2) / 4,
                .reason = "Verlet's energy of a mode oscillates by (omega tau)^2/4; omega is the rate of rise of the "
                          "wave at a point, celerity times tail decay rate"});
}

void claims(const Values& values, const Claims<Results>& all) {
  const long rows = values.integer("rows");
  for (const std::size_t k : indices(climbs.size())) {
    const Claims<Climbed> claims = all.at(resolution(rows)).entry(k);
    claim_whole(climbs[k], claims);
    claim_runup(climbs[k], exact_runup(values, climbs[k]), rows, claims);
    claim_energy(climbs[k], 0.2 / static_cast<double>(rows), claims);
  }
}

Reached reach(const Climb& climb, const exact::SolitaryWave& wave, long rows, double drift) {
  MeshClimb mesh = MeshClimb::with_rows(wave, rows);
  mesh.rezone = drift;
  if (!climb.wall()) mesh.tan_slope = 1 / climb.cot_slope;
  Reached reached{.spacing = mesh.spacing};
  double first = 0;
  MeshRun run = climb_on_mesh(mesh, [&](const Flow& flow) {
    const double taken = flow.rezoning().lost;
    if (flow.steps() == 1) first = flow.energy() + taken;
    reached.unbooked.add((flow.energy() + taken) / first - 1, flow.time());
    reached.taken = taken / first;
    reached.rezoned = static_cast<double>(flow.rezoning().done);
  });
  reached.runup = run.runup();
  reached.tangled = run.tangle.has_value();
  reached.x = std::move(run.x);
  reached.y = std::move(run.y);
  return reached;
}

Results compute(const Run& run) {
  Results all;
  for (const Climb& climb : climbs) {
    const exact::SolitaryWave wave(climb.amplitude);
    Climbed climbed{.climb = climb};
    for (const long part : parts) {
      climbed.on.push_back(reach(climb, wave, run.integer("rows") * part / parts.back(), run.real("drift")));
    }
    all.push_back(std::move(climbed));
    run.progress(static_cast<double>(all.size()) / climbs.size());
  }
  return all;
}

void tabulate(const Results& all, const Values& values, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(exhibit, "runup", "Run-up on rezoned meshes",
                                     "From coarse to fine; of the Euler equations; number of rezonings of the finest "
                                     "mesh and the fraction of wave energy that they took.",
                                     {"wave"});
  for (const long part : parts) {
    table.columns.emplace_back(fmt::format("{} rows", values.integer("rows") * part / parts.back()), "depth");
  }
  table.columns.insert(table.columns.end(), {{"exact", "depth"}, {"rezoned", "times"}, {"energy taken", "1"}});
  for (const Climbed& one : all) {
    std::vector<Cell>& row = table.rows.emplace_back(1, one.climb.title());
    for (const Reached& on : one.on) row.push_back(rounded(on.runup));
    row.insert(row.end(),
               {rounded(exact_runup(values, one.climb)), one.on.back().rezoned, rounded(one.on.back().taken, 1e6)});
  }
}

void draw_meshes(const Results& all, const Values& values, evidence::Exhibit& exhibit) {
  const auto rows = values.count("rows");
  auto& figure = exhibit.figure("meshes", "The mesh at the maximum run-up", resolution(values.integer("rows")) + ".");
  for (const std::size_t highest : {1, 5}) {  // at the wall, on the milder slope
    const Climbed& one = all.at(highest);
    const Reached& finest = one.on.back();
    if (finest.x.empty()) continue;
    const double shore = *std::ranges::max_element(finest.x);
    const MeshWindow window{.begin = shore - (one.climb.wall() ? 2.5 : 5), .end = shore + 0.1};
    const lagrangian_mesh_2d::Mesh mesh{{finest.x.size() / (rows + 1) - 1, rows}};
    draw_mesh(figure.panel(mesh_axes(one.climb.title(), window)), "mesh", mesh, finest.x, finest.y, window);
  }
}

void show(const Results& all, const Values& values, evidence::Exhibit& exhibit) {
  tabulate(all, values, exhibit);
  auto& panel = add_panel(exhibit, "convergence", "Convergence of the run-up",
                          "Relative to the exact values of the Euler equations.",
                          {.x = "h1 [depth]", .y = "|R/R_exact - 1|", .log_x = true, .log_y = true});
  for (const Climbed& one : all) {
    const double exact = exact_runup(values, one.climb);
    panel.points(one.climb.title(), one.spacings(),
                 each(one.on, [&](const Reached& on) { return std::abs(on.runup / exact - 1); }),
                 one.climb.wall() ? Role::computed : Role::peer);
  }
  slope_guide(panel, 2, all.front().spacings(),
              std::abs(all.front().on.back().runup / exact_runup(values, all.front().climb) - 1));
  draw_meshes(all, values, exhibit);
}

void run_up_mesh_rezoned(Case& c) {
  c.title = "Run-up of high solitary waves on walls and slopes: rezoned Lagrangian mesh";
  c.source = literature::frank + ", section 2.2; C. W. Hirt, A. A. Amsden, J. L. Cook, J. Comput. Phys. 14 (1974) 227";
  c.parameters = {
      integer("rows", {8, 16, 16}, {8, 32}, "of the finest mesh; the others have 1/2, 5/8 and 3/4 of them"),
      real("drift", 0.2, "cells", {0.05, 0.5}, "largest deviation of a node from its position before rezoning"),
  };
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::run_up_mesh_rezoned
