/*
A solitary wave of height $A$ on water of depth 1 climbs a plane slope $1 : \cot\beta$, computed with Frank's
one-dimensional discrete model: particles that slide along the bed, nodes on the surface, constant volume between
neighbouring nodes. The last node slides on the dry slope. No condition is imposed at the shoreline, and no threshold
defines a dry cell.

**Set-up.** The toe of the slope is at $x = -\cot\beta$, the still-water shoreline at $x = 0$. Serre's wave starts where
all but $10^{-4}$ of its height is before the toe. Gravity is 1. The step is $\tau = h/4$, or 0.3 of the longest stable
step where shallow water makes that smaller. The run-up is the first maximum of the shoreline, from a parabola through
the three highest steps.

**What is compared.** The run-up with Synolakis' law $R = 2.831\sqrt{\cot\beta}\,A^{5/4}$ in its range of validity: no
breaking on the way up, $A < 0.8183 (\cot\beta)^{-10/9}$, and a long beach, $A \gg (0.288 \tan\beta)^2$.

**What to look at.** The shoreline of the shallow-water equations beside the model, which lags slightly and, at finer
spacings, rises slightly less: the effect of dispersion.
*/
#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "seiche/exact/solitary_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases::run_up_1d {

using dispersive::Flow;

/// The beach is long where A is this many times (0.288 tan)^2, "much greater".
constexpr double much_greater = 10;

/// What the parameters decide.
struct SetUp {
  SolitaryClimb climb;
  exact::SolitaryRunup theory;
};

SetUp set_up(const Values& values) {
  const double cot_slope = values.real("cot_slope");
  const SolitaryClimb climb = climb_from(values, cot_slope, values.real("amplitude"));
  return {climb, {1, 1, climb.amplitude, cot_slope}};
}

struct Surface {
  double time = 0;
  std::vector<double> x, y;
};

/// What of it the figures show.
Surface surface_of(const Flow& flow, double cot_slope) {
  Surface surface{.time = flow.time()};
  for (const std::size_t i : indices(flow.x().size())) {
    if (flow.x()[i] < -2 * cot_slope - 5) continue;
    surface.x.push_back(flow.x()[i]);
    surface.y.push_back(flow.y()[i]);
  }
  return surface;
}

/// Time zero of the shoreline is when the undisturbed crest would be at the toe.
void draw_shoreline(evidence::Exhibit& exhibit, const RunUp& up, double toe_time, const exact::SolitaryRunup& theory) {
  auto& panel =
      add_panel(exhibit, "shoreline", "The shoreline",
                "Shoreline elevation, with the exact shallow-water shoreline until it breaks, and the run-up law.",
                {.x = "t [sqrt(depth/g)] since the crest was at the toe", .y = "elevation [depth]"});
  const double visible = 0.01 * theory.law();
  const auto rises = std::ranges::find_if(up.levels, [&](double y) { return y > visible; });
  const auto first = static_cast<std::size_t>(rises == up.levels.end() ? 0 : rises - up.levels.begin());
  const std::vector<double> all_times = up.since(toe_time);
  const std::span shown_time = std::span(all_times).subspan(first);
  panel.line("model", shown_time, std::span(up.levels).subspan(first), Role::computed);
  const std::vector<double> time =
      evenly(shown_time.front(), std::min(shown_time.back(), 0.999 * theory.breaking_time()), 201);
  panel.line("shallow-water equations", time, each(time, [&](double t) { return theory.shoreline(t).elevation; }),
             Role::exact);
  panel.line("run-up law", std::vector{shown_time.front(), shown_time.back()}, std::vector(2, theory.law()),
             Role::guide);
}

void draw_profiles(evidence::Exhibit& exhibit, const std::vector<Surface>& surfaces, double cot_slope) {
  auto& figure = exhibit.figure("profiles", "Run-up of the wave",
                                "Surface and bed when the crest is at the toe, and at the maximum run-up.");
  for (const Surface& one : surfaces) {
    const double lowest = -0.3;
    auto& panel = figure.panel(
        {.x = "x [depth]", .y = "elevation [depth]", .title = fmt::format("t = {:.1f}", one.time), .y_min = lowest});
    const double land = 1.2 * std::max(one.x.back(), 0.1 * cot_slope);
    panel.fill("bottom", std::vector{one.x.front(), -cot_slope, land}, std::vector{-1.0, -1.0, land / cot_slope},
               Role::bed);
    panel.line("surface", one.x, one.y, Role::computed);
  }
}

struct Results {
  SetUp set_up;
  std::vector<Surface> surfaces;
  RunUp up;
};

void claims(const Values& values, const Claims<Results>& claims) {
  const auto& [climb, theory] = set_up(values);
  claims.at(climb.resolution())
      .only_if(theory.nonbreaking(), "the wave breaks on its way up")
      .only_if(climb.amplitude >= much_greater * theory.short_beach_amplitude(), "the beach is too short for the law")
      .check(
          "law", "Maximum run-up agrees with Synolakis' run-up law within 5 %.", "run-up [depth]",
          [](const Results& r) { return r.up.height; },
          Bound{.limit = 0.05 + std::abs(theory.highest().elevation / theory.law() - 1),
                .reason =
                    "5 %, the tolerance of analytical benchmarks in Synolakis et al., NOAA Tech. Memo. OAR PMEL-135 "
                    "(2007), and the difference of the law from the integral of which it is the leading term",
                .expected = theory.law(),
                .relative = true});
}

Results compute(const Run& run) {
  Results r{.set_up = set_up(run), .surfaces = std::vector<Surface>(2)};
  const SolitaryClimb& climb = r.set_up.climb;
  const double toe_time = climb.time_to(-climb.cot_slope);
  const double expected_time = toe_time + 3 * climb.cot_slope + 10;
  const auto note = [&](const Flow& flow) {
    if (flow.time() <= toe_time) r.surfaces[0] = surface_of(flow, climb.cot_slope);
    Surface& highest = r.surfaces[1];
    if (highest.y.empty() || flow.y().back() > highest.y.back()) highest = surface_of(flow, climb.cot_slope);
    run.progress(std::min(1.0, flow.time() / expected_time));
  };
  r.up = run_up(climb, note, run.real("time"));
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  const auto& [climb, theory] = r.set_up;
  exhibit.measure("runup", r.up.height);
  exhibit.measure("time_of_maximum", r.up.time);
  const double toe_time = climb.time_to(-climb.cot_slope);
  exhibit.measure("time_of_maximum_after_toe", r.up.time - toe_time);
  exhibit.measure("runup_law", theory.law());
  exhibit.measure("runup_of_shallow_water_equations", theory.highest().elevation);
  exhibit.measure("amplitude_over_backwash_limit", climb.amplitude / backwash_limit(climb.cot_slope));
  draw_shoreline(exhibit, r.up, toe_time, theory);
  draw_profiles(exhibit, r.surfaces, climb.cot_slope);
}

void run_up_1d(Case& c) {
  c.title = "Run-up of a solitary wave on a plane slope";
  c.source = literature::frank + ", section 3.2; " + literature::synolakis;
  c.parameters = joined({{
                             real("cot_slope", 10.0, "1", {0.5, 50}, "s of the slope 1:s"),
                             real("amplitude", 0.03, "depth", {1e-3, 0.6}, "height of the incident wave"),
                             real("time", 400.0, "sqrt(depth/g)", {1, 1e4}, "latest end of the run"),
                         },
                         climb_parameters({0.25, 0.125, 0.0625}),
                         slope_parameters()});
  c.study = Study(claims, compute, show, "Synolakis (1987)");
}

}  // namespace seiche::validation::cases::run_up_1d
