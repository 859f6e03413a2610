/*
A solitary wave of the Euler equations climbs plane slopes of 1:1 and 1:2 on the two-dimensional Lagrangian mesh (Frank
1994, section 2.2). Depth and gravity are 1.

**Set-up.** The tank begins at $x = 0$, the crest starts at $x = 12$, the toe of the slope is at $x = 24$. Columns are
vertical in the tank and become parallel to the slope over the last $\max(4, 4\cot\beta)$. The last column of nodes
slides on the slope; its top is the contact point. In Frank's model the toe is a fixed node. In a second set of runs bed
and slope are one curve, rounded over a column's width on either side of the toe, along which the toe and its neighbours
slide; the scheme is the conservative one, and the hourglass potential, $\kappa_0 = 0.1$, keeps nodes in their rows. No
condition is imposed at the shoreline.

**What is compared.** The run-up, five amplitudes on each slope: with the exact values of the Euler equations (`seiche
exact slope_runup`), with the values of the thesis, which does not state its mesh, and with the formula of Hall and
Watts for their measurements.

**What to look at.** The run-up converges at first order only. A surface node feels the pressure half a cell below it,
which makes its motion along the surface first-order accurate, and on a slope the contact point climbs by such motion.
At a vertical wall it does not, and the order is two (`wall_run_up_mesh`). Extrapolated values agree within a few per
cent with the formula, a fit to measurements, and more closely with the exact values. Water arrives at the toe in finite
time and continues up the slope. With Frank's fixed toe a bed node cannot: it passes the toe, and the last cell at the
bed tangles, but its area remains correct and the run continues (`beyond_tangling`). With a sliding toe no cell tangles,
and energy is exact while nodes pass the corner. The difference of run-up between both toes is first-order like their
errors: 3 % for the highest wave on the 1:2 slope with columns an eighth wide, a few tenths of a per cent for most.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ranges>
#include <vector>

#include <fmt/format.h>

#include "reports/evidence/grid_convergence.hpp"
#include "seiche/exact/solitary_runup.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/case/reference_table.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/mesh_climb.hpp"
#include "validation/run_up/solitary_climb.hpp"
#include "validation/studies/lagrangian_mesh_2d/mesh_figure.hpp"

namespace seiche::validation::cases::slope_run_up_mesh {

// The run-ups on plane slopes that the two-dimensional Lagrangian mesh is judged by, and its own, on a sequence of
// meshes.
//
// Units: depth and gravity are 1.

struct MeshSize {
  double spacing;
  long rows;
  double tau;
};

constexpr std::array<MeshSize, 4> meshes{{{1, 2, 0.05}, {0.5, 4, 0.05}, {0.25, 8, 0.025}, {0.125, 16, 0.0125}}};

constexpr std::size_t compared = 3;  // meshes of all tiers

/// A row of the comparison, with what is known of it.
struct Row {
  double cot_slope = 0;
  double amplitude = 0;
  double thesis = nan;
  double exact = nan;

  ///< of Hall and Watts
  [[nodiscard]] double formula() const { return exact::HallWatts(1, 1 / cot_slope).runup(amplitude); }
};

struct Climbed : Row {
  std::vector<double> runup;          ///< on the meshes
  std::optional<double> tangle_time;  ///< first tangle on the finest mesh with one before the largest run-up
  std::vector<double> sliding;        ///< run-up with a toe that slides, on the meshes
  Count sliding_tangles;              ///< of them those with a tangle before it
  Worst sliding_energy;               ///< largest change over the wave's energy

  /// To zero spacing, first order; from the two finest meshes but `coarser`.
  [[nodiscard]] double extrapolated(std::size_t coarser = 0) const {
    const std::size_t n = runup.size() - coarser;
    return 2 * runup[n - 1] - runup[n - 2];
  }
  /// What the sliding toe changes on the finest mesh, over what the last halving of the cells changes with either toe.
  [[nodiscard]] double toe_matters() const {
    const std::size_t n = runup.size();
    const double left = std::abs(runup[n - 1] - runup[n - 2]) + std::abs(sliding[n - 1] - sliding[n - 2]);
    return (sliding[n - 1] - runup[n - 1]) / left;
  }
  /// Of the finest mesh's run-up; infinite where the meshes do not tell.
  [[nodiscard]] double mesh_uncertainty() const {
    return evidence::grid_convergence(each(std::span(meshes).first(runup.size()), &MeshSize::spacing), runup, 1)
        .uncertainty;
  }
  /// Of the difference from the exact run-up, from the last halving.
  [[nodiscard]] double order_of_error() const {
    return std::log2(std::abs(runup[runup.size() - 2] - exact) / std::abs(runup.back() - exact));
  }
  /// From the last two halvings.
  [[nodiscard]] double order() const {
    const std::size_t n = runup.size();
    return std::log2((runup[n - 2] - runup[n - 3]) / (runup[n - 1] - runup[n - 2]));
  }
};

/// Before the largest run-up.
bool tangles(const MeshRun& run) {
  return run.tangle && run.tangle->time < run.time_of_highest;
}

MeshClimb with_sliding_toe(MeshClimb climb) {
  climb.rounding = 1;
  climb.settings.hourglass = 0.1;
  climb.stepping = mechanics::Stepping::conservative;
  return climb;
}

/// Of the tables that the case declares.
std::vector<Row> rows_of(const Values& values) {
  const io::Table thesis = values.table("frank_1994_runup");
  const io::Table exact = values.table("slope_runup_exact");
  std::vector<Row> rows;
  for (std::size_t k = 0; k < exact.rows(); ++k) {
    Row& row = rows.emplace_back(Row{
        .cot_slope = exact.column("cot_slope")[k], .amplitude = exact.column("A")[k], .exact = exact.column("R")[k]});
    row.thesis =
        entry_where(thesis, {{"cot_slope", row.cot_slope}, {"A", row.amplitude}}, "R_calc").value_or(row.thesis);
  }
  return rows;
}

/// Climbs the slope on as many of the meshes, with a toe that stays and with one that slides.
Climbed climb_row(const Row& row, std::size_t levels) {
  const exact::SolitaryWave wave(row.amplitude);
  Climbed climbed{row, {}, {}, {}, {}, {}};
  for (std::size_t level = 0; level < levels; ++level) {
    const MeshSize& mesh = meshes[level];
    const MeshClimb climb{
        .wave = wave, .tan_slope = 1 / row.cot_slope, .spacing = mesh.spacing, .rows = mesh.rows, .tau = mesh.tau};
    const MeshRun result = climb_on_mesh(climb);
    climbed.runup.push_back(result.runup());
    if (tangles(result)) climbed.tangle_time = result.tangle->time;
    const MeshRun sliding = climb_on_mesh(with_sliding_toe(climb));
    climbed.sliding.push_back(sliding.runup());
    climbed.sliding_tangles.add(sliding.runup(), [&](double) { return tangles(sliding); });
    climbed.sliding_energy.add(sliding.energy_defect.value());
  }
  return climbed;
}

const std::string source = "Frank (1994), section 2.2 and table of chapter 3";

constexpr double latest_runup = 17;  // [sqrt(depth/g)], 12 depths to the toe at least as fast as a long wave, then up
constexpr double sweeps = 6;         // of a conservative step
constexpr double useful = 0.15;      // uncertainty over the run-up that still says something
constexpr double farthest = 27;      // place of a node [depth]

struct Results {
  MeshClimb climb;  ///< of the wave of the parameters
  MeshRun run;
  std::vector<Climbed> all = {};
};

std::size_t levels(const Values& values) {
  return values.tier() == Tier::quick ? compared : meshes.size();
}

void claim_thesis(const Claims<std::vector<Climbed>>& claims) {
  claims.at("h1 = 0.25, 8 rows")
      .check(
          "thesis", "Maximum run-up agrees with the two-dimensional model of Frank (1994) within the mesh uncertainty.",
          "largest |R/R_thesis - 1|",
          [](const std::vector<Climbed>& all) -> Measurement {
            Worst off;
            Largest halving;
            for (const Climbed& one : all) {
              off.add(one.runup[compared - 1] / one.thesis - 1, one.amplitude);
              halving.add(one.runup[compared - 1] / one.runup[compared - 2] - 1);
            }
            return {.value = off.value(),
                    .where = fmt::format("A = {:g}", off.where()),
                    .told = {.limit = halving.value()}};
          },
          Bound{.limit = Amount::told_by_run(useful),
                .reason = "the thesis does not state its mesh: the largest change by the last halving of the cells; "
                          "the two decimals of the thesis are 2 % of the lowest value"});
}

/// The order that is farthest from 1 of all waves.
Measurement order_off_first(const std::vector<Climbed>& all, double (Climbed::*order)() const) {
  Worst off;
  for (std::size_t k = 0; k < all.size(); ++k) off.add((all[k].*order)() - 1, static_cast<double>(k));
  const Climbed& worst = all.at(static_cast<std::size_t>(off.where()));
  return {.value = (worst.*order)(), .where = fmt::format("A = {:g}, cot = {:g}", worst.amplitude, worst.cot_slope)};
}

void claim_convergence(const Claims<std::vector<Climbed>>& claims) {
  claims.at("three finest meshes")
      .from("contact points climb along the surface, where nodes are first-order accurate")
      .check(
          "order", "The run-up on slopes converges at first order.",
          "order from the last two halvings, farthest from 1 of all waves",
          [](const std::vector<Climbed>& all) { return order_off_first(all, &Climbed::order); },
          Bound{.limit = 0.5,
                .reason = "half an order: three meshes, the coarsest with four rows or less",
                .expected = 1});
}

void claim_exact(const Claims<std::vector<Climbed>>& claims, std::size_t levels) {
  const auto finest = claims.at(fmt::format("h1 = {:g}", meshes[levels - 1].spacing)).where("A = {:g}");
  finest.check(
      "exact", "The run-up agrees with the Euler equations within the finest mesh's uncertainty.",
      "largest difference over the mesh uncertainty",
      [](const std::vector<Climbed>& all) {
        return over<Worst>(
            all,
            [](const Climbed& one) {
              return (one.runup.back() - one.exact) / std::min(one.mesh_uncertainty(), useful * one.exact);
            },
            &Climbed::amplitude);
      },
      Bound{.limit = 1,
            .reason = "the 95 % half-width from the change between meshes, at most 15 % of the run-up; exact values to "
                      "seven digits"});
  finest.check(
      "exact-order", "The run-up converges to the Euler equations at first order.",
      "order of the difference from the last halving, farthest from 1 of all waves",
      [](const std::vector<Climbed>& all) { return order_off_first(all, &Climbed::order_of_error); },
      Bound{.limit = 0.5, .reason = "half an order, as for the order from the meshes alone", .expected = 1});
}

void claim_measurements(const Claims<std::vector<Climbed>>& claims, std::size_t levels) {
  claims.at(fmt::format("to zero from h1 = {:g} and {:g}", meshes[levels - 2].spacing, meshes[levels - 1].spacing))
      .from("Hall and Watts (1953)")
      .check(
          "measurements",
          "The run-up extrapolated to fine meshes agrees with the formula of Hall and Watts (1953) within its scatter.",
          "rms of R/R_formula - 1",
          [](const std::vector<Climbed>& all) -> Measurement {
            const auto deviation =
                over<Mean>(all, [](const Climbed& one) { return one.extrapolated() / one.formula() - 1; });
            // By the last halving: three times what the next order leaves; no rms changes by more.
            const auto change = over<Mean>(
                all, [](const Climbed& one) { return (one.extrapolated() - one.extrapolated(1)) / one.formula(); });
            return {.value = deviation.rms(), .uncertainty = change.rms()};
          },
          Uncertainty{.data = exact::HallWatts::scatter(),
                      .useful = useful,
                      .reason = "scatter of the measurements about their formula, 5 % (assumed); of the extrapolation, "
                                "the change by the last halving of the cells"});
}

void claim_sliding_toe(const Claims<std::vector<Climbed>>& claims, std::size_t levels) {
  const double finest = meshes[levels - 1].tau;
  claims.at("all meshes")
      .check(
          "tangles", "The number of tangled meshes before the maximum run-up, with a sliding toe, is zero.",
          "tangled meshes, all waves",
          [](const std::vector<Climbed>& all) {
            return over<Mean>(all, [](const Climbed& one) { return one.sliding_tangles.value(); }).sum();
          },
          Bound{.limit = 0, .reason = "none"});
  claims.at("all meshes")
      .where("A = {:g}")
      .from("discrete gradient, with chords as tangents: exact on any curve")
      .check(
          "energy", "The energy is conserved to round-off until the maximum run-up while nodes slide around the toe.",
          "largest change over the wave energy",
          [](const std::vector<Climbed>& all) {
            return over<Worst>(
                all, [](const Climbed& one) { return one.sliding_energy.value(); }, &Climbed::amplitude);
          },
          Roundoff{
              .operations = latest_runup / finest * sweeps,
              .scale = farthest,
              .reason =
                  "one rounded position, at most 27 h from the origin, per sweep, six sweeps per step, up to t = 17 on "
                  "the finest mesh; pressures of the wave height do the work of the wave energy over one depth"});
  claims.at(fmt::format("h1 = {:g}", meshes[levels - 1].spacing))
      .where("A = {:g}")
      .check(
          "toe", "The difference of run-up between fixed and sliding toe is at most 1.0 times the mesh errors of both.",
          "largest difference of run-up over the change by the last halving of the cells with both toes",
          [](const std::vector<Climbed>& all) { return over<Worst>(all, &Climbed::toe_matters, &Climbed::amplitude); },
          Bound{.limit = 1,
                .reason = "first order: the change by the last halving equals the remaining error of each"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const auto all = claims.of(&Results::all);
  claim_thesis(all);
  claim_convergence(all);
  claim_exact(all, levels(values));
  claim_measurements(all, levels(values));
  claim_sliding_toe(all, levels(values));
}

MeshClimb climb_of(const Values& values) {
  MeshClimb climb = mesh_climb_from(values, exact::SolitaryWave(values.real("amplitude")));
  climb.tan_slope = values.real("tan_slope");
  climb.rounding = values.real("rounding");
  climb.beyond_tangling = values.toggle("beyond_tangling");
  return climb;
}

Results compute(const Run& run) {
  const MeshClimb climb = climb_of(run);
  Results r{.climb = climb, .run = climb_on_mesh(climb)};
  run.progress(0.1);
  const std::vector<Row> rows = rows_of(run);
  for (const Row& row : rows) {
    r.all.push_back(climb_row(row, levels(run)));
    run.progress(0.1 + 0.9 * static_cast<double>(r.all.size()) / static_cast<double>(rows.size()));
  }
  return r;
}

void tabulate(const std::vector<Climbed>& all, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(
      exhibit, "runup", "Run-up on slopes",
      "Meshes of columns 1, 1/2, 1/4 wide, then extrapolated from the two finest; finest mesh with a sliding toe; "
      "Euler equations; the thesis; the formula of Hall and Watts; first inversion of a cell before the maximum run-up "
      "with Frank's toe, on the finest mesh where one occurs.",
      {"tan [1]", "A [depth]", "R (1) [depth]", "R (1/2) [depth]", "R (1/4) [depth]", "extrapolated [depth]",
       "sliding toe [depth]", "exact [depth]", "thesis [depth]", "Hall-Watts [depth]", "tangled at [sqrt(depth/g)]"},
      {"frank-slopes-2d"});
  for (const Climbed& one : all) {
    std::vector<Cell>& cells = table.rows.emplace_back(std::vector<Cell>{1 / one.cot_slope, one.amplitude});
    for (std::size_t m = 0; m < compared; ++m) cells.push_back(rounded(one.runup[m]));
    cells.insert(cells.end(), {rounded(one.extrapolated()), rounded(one.sliding.back()), rounded(one.exact), one.thesis,
                               rounded(one.formula()), one.tangle_time ? rounded(*one.tangle_time) : ""});
  }
}

void draw(const std::vector<Climbed>& all, evidence::Exhibit& exhibit) {
  auto& figure = exhibit.figure("runup", "Run-up of solitary waves on slopes",
                                "Frank's two-dimensional model on meshes of columns 1, 1/2, 1/4 wide and extrapolated, "
                                "his own values, and the formula of Hall and Watts with its scatter of 5 %.",
                                {"frank-slopes-2d"});
  for (const double cot_slope : {1.0, 2.0}) {
    auto& panel = figure.panel({.x = "A [depth]", .y = "R [depth]", .title = fmt::format("slope {:g}", 1 / cot_slope)});
    const std::vector<double> fine = evenly(0.05, 0.55, 51);
    const exact::HallWatts law(1, 1 / cot_slope);
    panel.line("Hall and Watts", fine, each(fine, [&](double a) { return law.runup(a); }), Role::guide);
    auto those = all | std::views::filter([&](const Climbed& one) { return one.cot_slope == cot_slope; });
    const std::vector<double> a = each(those, &Climbed::amplitude);
    panel.points("Euler equations", a, each(those, &Climbed::exact), Role::exact);
    panel.points("thesis", a, each(those, &Climbed::thesis), Role::data);
    for (std::size_t m = 0; m < compared; ++m) {
      panel.line(fmt::format("h1 = {:g}", meshes[m].spacing), a,
                 each(those, [&](const Climbed& one) { return one.runup[m]; }));
    }
    panel.line("extrapolated", a, each(those, [](const Climbed& one) { return one.extrapolated(); }), Role::peer);
  }
}

void show_one(const MeshClimb& climb, const MeshRun& run, evidence::Exhibit& exhibit) {
  exhibit.measure("runup", run.runup());
  exhibit.measure("time_of_maximum", run.time_of_highest);
  exhibit.measure("energy_defect", run.energy_defect.value());
  if (run.tangle) {
    exhibit.measure("tangle_time", run.tangle->time);
    exhibit.measure("tangle_place", run.tangle->place);
  }
  const std::string title =
      fmt::format("A = {:g}, slope {:g}, {}.", climb.wave.amplitude(), climb.tan_slope, climb.resolution());
  add_panel(exhibit, "shoreline", "Elevation of the contact point", title,
            {.x = "t [sqrt(depth/g)]", .y = "elevation [depth]"})
      .line("contact point", run.times, run.levels);
  const double highest = run.fell ? run.runup() : largest(run.levels);
  const MeshWindow window{climb.toe - 4, climb.toe + (1 + 1.1 * highest) / climb.tan_slope};
  draw_mesh(
      add_panel(exhibit, "mesh", "The mesh at the maximum run-up", title, mesh_axes("", window), {"frank-slopes-2d"}),
      "mesh", run.flow.model().mesh(), run.x, run.y, window);
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  show_one(r.climb, r.run, exhibit);
  exhibit.measure("waves_that_tangle_with_a_toe_that_stays",
                  static_cast<double>(
                      std::ranges::count_if(r.all, [](const Climbed& one) { return one.tangle_time.has_value(); })));
  const std::vector<double> orders = each(r.all, &Climbed::order);
  exhibit.measure("smallest_order", smallest(orders));
  exhibit.measure("largest_order", largest(orders));
  tabulate(r.all, exhibit);
  draw(r.all, exhibit);
}

void slope_run_up_mesh(Case& c) {
  c.former_names = {"slope_run_up_2d"};
  c.title = "Run-up of a solitary wave on steep slopes: two-dimensional Lagrangian mesh";
  c.source = literature::frank + ", section 2.2 and table of chapter 3; " + literature::hall_watts;
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = joined({{real("amplitude", 0.29, "depth", {0.01, 0.6}, "height of the incident wave"),
                          real("tan_slope", 1.0, "1", {0.3, 5}, "slope, vertical over horizontal")},
                         mesh_parameters(0.25, 8, 0.025),
                         {real("rounding", 0.0, "columns", {0, 4}, "of the toe, to either side; 0: fixed toe node"),
                          toggle("beyond_tangling", true, "continue when a cell inverts, as in Frank's model")}});
  c.published = {{.tiles = {"frank-slopes-2d"}, .stated = {"tan_slope", "scheme"}}};
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::slope_run_up_mesh
