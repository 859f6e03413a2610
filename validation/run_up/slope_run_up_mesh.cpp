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
constexpr double useful = 0.15;      // uncertainty over the run-up that still says something

/// A wave of the comparison, what is known of it, and what the meshes make of it.
struct Climbed {
  double cot_slope = 0, amplitude = 0;
  double exact = nan, thesis = nan;
  std::vector<double> runup = {};          ///< on the meshes
  std::optional<double> tangle_time = {};  ///< first tangle on the finest mesh with one before the largest run-up
  std::vector<double> sliding = {};        ///< run-up with a toe that slides, on the meshes
  Count sliding_tangles = {};              ///< of them those with a tangle before it
  Worst sliding_energy = {};               ///< largest change over the wave's energy

  /// Of Hall and Watts.
  [[nodiscard]] double formula() const { return exact::HallWatts(1, 1 / cot_slope).runup(amplitude); }
  /// To zero spacing, first order; from the two finest meshes but `coarser`.
  [[nodiscard]] double extrapolated(std::size_t coarser = 0) const {
    const std::size_t n = runup.size() - coarser;
    return 2 * runup[n - 1] - runup[n - 2];
  }
  /// Change of a sequence by the halving before the last `earlier` ones.
  static double halving(const std::vector<double>& of, std::size_t earlier = 0) {
    return of[of.size() - 1 - earlier] - of[of.size() - 2 - earlier];
  }
  /// What the sliding toe changes on the finest mesh, over what the last halving of the cells changes with either toe.
  [[nodiscard]] double toe_matters() const {
    return (sliding.back() - runup.back()) / (std::abs(halving(runup)) + std::abs(halving(sliding)));
  }
  /// Over the uncertainty of the finest mesh's run-up, which is infinite where the meshes do not tell.
  [[nodiscard]] double off_exact() const {
    const double uncertainty =
        evidence::grid_convergence(each(std::span(meshes).first(runup.size()), &MeshSize::spacing), runup, 1)
            .uncertainty;
    return (runup.back() - exact) / std::min(uncertainty, useful * exact);
  }
  /// Of the difference from the exact run-up, from the last halving.
  [[nodiscard]] double order_of_error() const {
    return std::log2(std::abs(runup[runup.size() - 2] - exact) / std::abs(runup.back() - exact));
  }
  /// From the last two halvings.
  [[nodiscard]] double order() const { return std::log2(halving(runup, 1) / halving(runup)); }
  [[nodiscard]] double energy_around_toe() const { return sliding_energy.value(); }
};
using All = std::vector<Climbed>;

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
All known_waves(const Values& values) {
  const io::Table thesis = values.table("frank_1994_runup");
  const io::Table exact = values.table("slope_runup_exact");
  All waves;
  for (std::size_t k = 0; k < exact.rows(); ++k) {
    const double cot_slope = exact.column("cot_slope")[k];
    const double amplitude = exact.column("A")[k];
    const auto printed = entry_where(thesis, {{"cot_slope", cot_slope}, {"A", amplitude}}, "R_calc");
    waves.push_back({cot_slope, amplitude, exact.column("R")[k], printed.value_or(nan)});
  }
  return waves;
}

/// Climbs the slope on as many of the meshes, with a toe that stays and with one that slides.
void climb(Climbed& wave, std::size_t levels) {
  const exact::SolitaryWave incident(wave.amplitude);
  for (const MeshSize& mesh : std::span(meshes).first(levels)) {
    const MeshClimb climb{
        .wave = incident, .tan_slope = 1 / wave.cot_slope, .spacing = mesh.spacing, .rows = mesh.rows, .tau = mesh.tau};
    const MeshRun result = climb_on_mesh(climb);
    wave.runup.push_back(result.runup());
    if (tangles(result)) wave.tangle_time = result.tangle->time;
    const MeshRun sliding = climb_on_mesh(with_sliding_toe(climb));
    wave.sliding.push_back(sliding.runup());
    wave.sliding_tangles.add(sliding.runup(), [&](double) { return tangles(sliding); });
    wave.sliding_energy.add(sliding.energy_defect.value());
  }
}

const std::string source = "Frank (1994), section 2.2 and table of chapter 3";

constexpr double latest_runup = 17;  // [sqrt(depth/g)], 12 depths to the toe at least as fast as a long wave, then up
constexpr double sweeps = 6;         // of a conservative step
constexpr double farthest = 27;      // place of a node [depth]

struct Results {
  MeshClimb climb;  ///< of the wave of the parameters
  MeshRun run;
  All all;
};

std::size_t levels(const Values& values) {
  return values.tier() == Tier::quick ? compared : meshes.size();
}

/// The order that is farthest from 1 of all waves.
auto order_off_first(double (Climbed::*order)() const) {
  return [order](const All& all) -> Measurement {
    Worst off;
    for (const std::size_t k : indices(all.size())) off.add((all[k].*order)() - 1, static_cast<double>(k));
    const Climbed& worst = all.at(static_cast<std::size_t>(off.where()));
    return {.value = (worst.*order)(), .where = fmt::format("A = {:g}, cot = {:g}", worst.amplitude, worst.cot_slope)};
  };
}

auto worst_of(double (Climbed::*number)() const) {
  return [number](const All& all) { return over<Worst>(all, number, &Climbed::amplitude); };
}

void claim_fixed_toe(const Claims<All>& claims, double coarser, double finest) {
  claims.at("h1 = 0.25, 8 rows")
      .check(
          "thesis", "Maximum run-up agrees with the two-dimensional model of Frank (1994) within the mesh uncertainty.",
          "largest |R/R_thesis - 1|",
          [](const All& all) -> Measurement {
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
  claims.at("three finest meshes")
      .from("contact points climb along the surface, where nodes are first-order accurate")
      .check("order", "The run-up on slopes converges at first order.",
             "order from the last two halvings, farthest from 1 of all waves", order_off_first(&Climbed::order),
             Bound{.limit = 0.5,
                   .reason = "half an order: three meshes, the coarsest with four rows or less",
                   .expected = 1});
  const auto on_finest = claims.at(fmt::format("h1 = {:g}", finest)).where("A = {:g}");
  on_finest.check("exact", "The run-up agrees with the Euler equations within the finest mesh's uncertainty.",
                  "largest difference over the mesh uncertainty", worst_of(&Climbed::off_exact),
                  Bound{.limit = 1,
                        .reason = "the 95 % half-width from the change between meshes, at most 15 % of the run-up; "
                                  "exact values to seven digits"});
  on_finest.check(
      "exact-order", "The run-up converges to the Euler equations at first order.",
      "order of the difference from the last halving, farthest from 1 of all waves",
      order_off_first(&Climbed::order_of_error),
      Bound{.limit = 0.5, .reason = "half an order, as for the order from the meshes alone", .expected = 1});
  claims.at(fmt::format("to zero from h1 = {:g} and {:g}", coarser, finest))
      .from("Hall and Watts (1953)")
      .check(
          "measurements",
          "The run-up extrapolated to fine meshes agrees with the formula of Hall and Watts (1953) within its scatter.",
          "rms of R/R_formula - 1",
          [](const All& all) -> Measurement {
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

void claim_sliding_toe(const Claims<All>& claims, const MeshSize& finest) {
  const auto on_all = claims.at("all meshes").where("A = {:g}");
  on_all.check(
      "tangles", "The number of tangled meshes before the maximum run-up, with a sliding toe, is zero.",
      "tangled meshes, all waves",
      [](const All& all) {
        return over<Mean>(all, [](const Climbed& one) { return one.sliding_tangles.value(); }).sum();
      },
      Bound{.limit = 0, .reason = "none"});
  on_all.from("discrete gradient, with chords as tangents: exact on any curve")
      .check("energy",
             "The energy is conserved to round-off until the maximum run-up while nodes slide around the toe.",
             "largest change over the wave energy", worst_of(&Climbed::energy_around_toe),
             Roundoff{
                 .operations = latest_runup / finest.tau * sweeps,
                 .scale = farthest,
                 .reason =
                     "one rounded position, at most 27 h from the origin, per sweep, six sweeps per step, up to t = 17 "
                     "on the finest mesh; pressures of the wave height do the work of the wave energy over one depth"});
  claims.at(fmt::format("h1 = {:g}", finest.spacing))
      .where("A = {:g}")
      .check("toe",
             "The difference of run-up between fixed and sliding toe is at most 1.0 times the mesh errors of both.",
             "largest difference of run-up over the change by the last halving of the cells with both toes",
             worst_of(&Climbed::toe_matters),
             Bound{.limit = 1,
                   .reason = "first order: the change by the last halving equals the remaining error of each"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const auto all = claims.of(&Results::all);
  const std::size_t finest = levels(values) - 1;
  claim_fixed_toe(all, meshes[finest - 1].spacing, meshes[finest].spacing);
  claim_sliding_toe(all, meshes[finest]);
}

MeshClimb climb_of(const Values& values) {
  MeshClimb climb = mesh_climb_from(values, exact::SolitaryWave(values.real("amplitude")));
  climb.tan_slope = values.real("tan_slope");
  climb.rounding = values.real("rounding");
  climb.beyond_tangling = values.toggle("beyond_tangling");
  return climb;
}

Results compute(const Run& run) {
  const MeshClimb shown = climb_of(run);
  Results r{.climb = shown, .run = climb_on_mesh(shown), .all = known_waves(run)};
  run.progress(0.1);
  double done = 0;
  for (Climbed& wave : r.all) {
    climb(wave, levels(run));
    run.progress(0.1 + 0.9 * ++done / static_cast<double>(r.all.size()));
  }
  return r;
}

void tabulate(const All& all, evidence::Exhibit& exhibit) {
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

void draw(const All& all, evidence::Exhibit& exhibit) {
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
