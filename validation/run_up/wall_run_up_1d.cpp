/*
A solitary wave runs against a vertical wall over a level bed: the same flow as the head-on collision of two equal
waves. The exact run-up of the Euler equations is known to many digits (`wall_run_up_exact`). The case measures the
error of Serre's equations, to which Frank's one-dimensional model converges over a level bed.

**Set-up.** Depth and gravity are 1. Serre's wave starts where all but $10^{-4}$ of its height is before the wall. The
last node slides up and down the wall; the run-up is its first maximum, from a parabola through the three highest steps,
extrapolated to zero spacing (Richardson).

**What is compared.** The run-up for several heights with the Euler equations, and with the series $R = 2A + \tfrac12
A^2$ (Byatt-Smith) and $R = 2A + \tfrac12 A^2 + \tfrac34 A^3$ (Su and Mirie). Both flows have the same series to the
order at which long-wave theory holds; the case measures that order.

**What to look at.** The difference from the Euler equations grows nearly like $A^5$. The model is too low by 0.02 % at
$A = 0.1$, 0.25 % at $0.2$, 3 % at $0.4$ and 15 % at $0.6$, where the water rises at the wall as a thin sheet, which a
depth-uniform velocity cannot represent.
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "seiche/exact/overturning/wall_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases::wall_run_up_1d {

using exact::WallRunup;

const std::string source = "Su and Mirie (1980); Serre (1953)";

/// All heights of the table of exact values.
struct Comparison {
  std::vector<double> amplitude, euler;
  std::vector<RunUpSequence> heights = {};  ///< with the spacing and twice and four times that

  [[nodiscard]] double serre(std::size_t k) const { return heights.at(k).limit().extrapolated; }
  [[nodiscard]] double gap(std::size_t k) const { return std::abs(serre(k) - euler[k]); }
};

Comparison compare(const Run& run) {
  const io::Table table = run.table("wall_runup_exact");
  Comparison all{.amplitude = table.column("a"), .euler = table.column("R")};
  for (const double a : all.amplitude) {
    const SolitaryClimb climb = climb_from(run, 0, a);
    all.heights.push_back(run_ups(climb, {4 * climb.spacing, 2 * climb.spacing, climb.spacing}));
    run.progress(0.2 + 0.8 * static_cast<double>(all.heights.size()) / static_cast<double>(all.amplitude.size()));
  }
  return all;
}

/// Largest distance from the Euler equations over that of the second-order series.
Worst over_series(const Comparison& all) {
  return over<Worst>(
      indices(all.amplitude.size()),
      [&](std::size_t k) { return all.gap(k) / (WallRunup::byatt_smith(all.amplitude[k]) - all.euler[k]); },
      [&](std::size_t k) { return all.amplitude[k]; });
}

void measure_comparison(evidence::Exhibit& exhibit, const Comparison& all) {
  constexpr std::size_t lowest = 4;  // A = 0.1 to 0.4
  const std::vector<double> gap = each(indices(lowest), [&](std::size_t k) { return all.gap(k); });
  // No theory says this power: it is shown, not judged.
  exhibit.measure("power_of_the_difference_from_euler",
                  evidence::observed_order({all.amplitude.begin(), all.amplitude.begin() + lowest}, gap).order);
}

void draw_comparison(evidence::Exhibit& exhibit, const Comparison& all) {
  const std::vector<double> fine = evenly(0.05, all.amplitude.back(), 101);
  const auto waves = indices(all.amplitude.size());
  const std::vector<double> serre = each(waves, [&](std::size_t k) { return all.serre(k); });
  const std::vector<double> gap = each(waves, [&](std::size_t k) { return all.gap(k); });
  auto& figure = exhibit.figure("runup", "Run-up on a vertical wall",
                                "Model extrapolated to zero spacing, exact values of the Euler equations, and series; "
                                "then the difference of model and Euler equations.");
  auto& heights = figure.panel({.x = "A [depth]", .y = "R/A"});
  heights.line("Euler equations", all.amplitude, quotients(all.euler, all.amplitude), Role::exact);
  heights.points("model", all.amplitude, quotients(serre, all.amplitude), Role::computed);
  heights.line("Su and Mirie", fine, each(fine, [](double a) { return WallRunup::su_mirie(a) / a; }), Role::guide);
  heights.line("Byatt-Smith", fine, each(fine, [](double a) { return WallRunup::byatt_smith(a) / a; }), Role::guide);
  auto& difference = figure.panel({.x = "A [depth]", .y = "|R - R_Euler| [depth]", .log_x = true, .log_y = true});
  difference.points("model", all.amplitude, gap, Role::computed);
  std::vector<double> fifth =
      each(all.amplitude, [&](const double a) { return gap[1] * std::pow(a / all.amplitude[1], 5); });
  difference.line("A^5", all.amplitude, fifth, Role::guide);
}

struct Results {
  SolitaryClimb climb;
  RunUp up = {};
  Comparison comparison = {};
};

SolitaryClimb climb_of(const Values& values) {
  return climb_from(values, 0, values.real("amplitude"));
}

void claims(const Values& values, const Claims<Results>& claims) {
  const SolitaryClimb climb = climb_of(values);
  const auto compared = claims.of(&Results::comparison)
                            .at(fmt::format("h = {:g} to {:g}, extrapolated, tau = {:g} h", 4 * climb.spacing,
                                            climb.spacing, climb.tau_over_spacing));
  compared.check("second-order",
                 "The run-up error against the Euler equations at all heights is smaller than the error of the "
                 "second-order series.",
                 "largest difference over the difference of 2A + A^2/2", over_series,
                 Bound{.limit = 1, .reason = "nearer means less than 1"});
}

Results compute(const Run& run) {
  const SolitaryClimb climb = climb_of(run);
  Results r{.climb = climb, .up = run_up(climb)};
  run.progress(0.2);
  r.comparison = compare(run);
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  exhibit.measure("runup", r.up.height);
  exhibit.measure("time_of_maximum", r.up.time);
  exhibit.measure("delay_of_maximum", r.up.time - r.climb.time_to(0));
  exhibit.measure("su_mirie", WallRunup::su_mirie(r.climb.amplitude));
  measure_comparison(exhibit, r.comparison);
  add_panel(exhibit, "wall", "Water level at the wall",
            fmt::format("A = {:g}; time since the undisturbed crest is at the wall.", r.climb.amplitude),
            {.x = "t [sqrt(depth/g)]", .y = "elevation [depth]"})
      .line("model", r.up.since(r.climb.time_to(0)), r.up.levels, Role::computed);
  draw_comparison(exhibit, r.comparison);
}

void wall_run_up_1d(Case& c) {
  c.title = "Run-up of a solitary wave on a vertical wall: Serre against Euler equations";
  c.source = literature::su_mirie + "; F. Serre, La Houille Blanche 8 (1953) 374; " + literature::frank + ", chapter 3";
  c.parameters = joined({{real("amplitude", 0.4, "depth", {0.05, 0.6}, "height of the incident wave")},
                         climb_parameters({0.05, 0.025, 0.0125})});
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::wall_run_up_1d
