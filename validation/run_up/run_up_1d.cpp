/*
A solitary wave of height $A$ on water of depth 1 climbs a plane slope of cotangent $\cot\beta$. Frank's
one-dimensional discrete model follows it: particles that slide along the bottom, markers on the surface, constant water
between neighbouring markers. The last marker slides on the dry slope. No condition is set at the shoreline, and no
threshold says what is dry.

**Set-up.** The toe of the slope is at $x = -\cot\beta$, the shoreline at rest at $x = 0$. Serre's wave starts where all
but $10^{-4}$ of its height is before the toe. Gravity is 1. The step is $\tau = h/4$, or less where the water is so
shallow that this would be more than $0.3$ of the longest stable step. The run-up is the first maximum of the
shoreline, from a parabola through the three highest steps.

**What is compared.** The energy of the water while the wave climbs. The run-up with Synolakis' law
$R = 2.831\sqrt{\cot\beta}\,A^{5/4}$, where that law holds: the wave does not break on its way up,
$A < 0.8183 (\cot\beta)^{-10/9}$, and the beach is long, $A \gg (0.288 \tan\beta)^2$.

**What to look at.** The shoreline of the shallow-water equations beside that of the model, which comes a little later
and, with finer markers, rises a little less: what dispersion does.
*/
#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "seiche/exact/solitary_runup.hpp"
#include "validation/case/case.hpp"
#include "validation/instruments/processor_time.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases {
namespace {

using dispersive::Flow;
using evidence::Role;

/// The beach is long where A is this many times (0.288 tan)^2, "much greater".
constexpr double much_greater = 10;

struct History {
  std::vector<double> time;
  std::vector<double> shoreline;
};

struct Snapshot {
  double time = 0;
  std::vector<double> x;
  std::vector<double> y;
};

Snapshot snapshot_of(const Flow& flow) {
  return {.time = flow.time(), .x = {flow.x().begin(), flow.x().end()}, .y = {flow.y().begin(), flow.y().end()}};
}

/// Time zero of the shoreline is when the undisturbed crest would be at the toe.
void draw_shoreline(evidence::Record& record, const History& history, const exact::SolitaryRunup& theory, double law) {
  auto& panel = record
                    .figure("shoreline", "The shoreline",
                            "Elevation of the water's edge, with the exact shoreline of the shallow-water equations "
                            "until that breaks, and the run-up law.")
                    .panel({.x = "t [sqrt(depth/g)] since the crest was at the toe", .y = "elevation [depth]"});
  constexpr double visible = 0.01;  // of the law
  const auto rises = std::ranges::find_if(history.shoreline, [&](double y) { return y > visible * law; });
  const auto first = rises - history.shoreline.begin();
  const std::span shown_time = std::span(history.time).subspan(static_cast<std::size_t>(first));
  panel.line("model", shown_time, std::span(history.shoreline).subspan(static_cast<std::size_t>(first)),
             Role::computed);
  std::vector<double> time;
  std::vector<double> elevation;
  const double end = std::min(shown_time.back(), 0.999 * theory.breaking_time());
  for (const double t : evenly(shown_time.front(), end, 201)) {
    time.push_back(t);
    elevation.push_back(theory.shoreline(t).elevation);
  }
  panel.line("shallow-water equations", time, elevation, Role::exact);
  panel.line("run-up law", std::vector{shown_time.front(), shown_time.back()}, std::vector{law, law}, Role::guide);
}

void draw_profiles(evidence::Record& record, const std::vector<Snapshot>& snapshots, double cot_slope) {
  auto& figure = record.figure("profiles", "The wave climbs",
                               "Surface and bottom when the crest is at the toe, and at the largest run-up.");
  for (const Snapshot& one : snapshots) {
    const double lowest = -0.3;
    auto& panel = figure.panel(
        {.x = "x [depth]", .y = "elevation [depth]", .title = fmt::format("t = {:.1f}", one.time), .y_min = lowest});
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      if (one.x[i] < -2 * cot_slope - 5) continue;
      x.push_back(one.x[i]);
      y.push_back(one.y[i]);
    }
    const double land = 1.2 * std::max(x.back(), 0.1 * cot_slope);
    panel.fill("bottom", std::vector{x.front(), -cot_slope, land}, std::vector{-1.0, -1.0, land / cot_slope},
               Role::bed);
    panel.line("surface", x, y, Role::computed);
  }
}

void claim_law(evidence::Record& record, const SolitaryClimb& climb, double runup, const exact::SolitaryRunup& theory) {
  const double law = theory.law();
  if (!theory.nonbreaking() || climb.amplitude < much_greater * theory.short_beach_amplitude()) return;
  record.check({.id = "law",
                .text = "The run-up is that of the run-up law.",
                .quantity = "run-up",
                .unit = "depth",
                .source = "Synolakis (1987)"},
               {.value = runup, .resolution = climb.resolution()},
               evidence::Bound{.limit = 0.05 + std::abs(theory.highest().elevation / law - 1),
                               .reason = "5 %, the tolerance of analytical benchmarks in Synolakis et al., NOAA Tech. "
                                         "Memo. OAR PMEL-135 (2007), and the law's own distance from the integral of "
                                         "which it is the leading term",
                               .expected = law,
                               .relative = true});
}

void run(Running& run) {
  const double cot_slope = run.real("cot_slope");
  const SolitaryClimb climb = climb_from(run.values(), cot_slope, run.real("amplitude"));
  const exact::SolitaryRunup theory(1, 1, climb.amplitude, cot_slope);
  const double toe_time = climb.time_to(-cot_slope);
  const double expected_time = toe_time + 3 * cot_slope + 10;

  History history;
  std::vector<Snapshot> snapshots(2);
  const auto note = [&](const Flow& flow) {
    const double shoreline = flow.y().back();
    if (flow.time() <= toe_time) snapshots[0] = snapshot_of(flow);
    if (history.shoreline.empty() || shoreline > snapshots[1].y.back()) snapshots[1] = snapshot_of(flow);
    history.time.push_back(flow.time() - toe_time);
    history.shoreline.push_back(shoreline);
    run.progress(std::min(1.0, flow.time() / expected_time));
  };
  const double begin = processor_seconds();
  const RunUp up = run_up(climb, {.ledger = true, .after_step = note, .latest = run.real("time")});
  const double elapsed = processor_seconds() - begin;

  run.record.measure("runup", up.height);
  run.record.measure("time_of_maximum", up.time);
  run.record.measure("time_of_maximum_after_toe", up.time - toe_time);
  run.record.measure("runup_law", theory.law());
  run.record.measure("runup_of_shallow_water_equations", theory.highest().elevation);
  run.record.measure("markers", static_cast<double>(up.markers));
  run.record.measure("steps", static_cast<double>(up.steps));
  run.record.measure("seconds", elapsed);
  run.record.measure("amplitude_over_backwash_limit", climb.amplitude / backwash_limit(cot_slope));
  claim_energy(run.record, climb, up);
  claim_law(run.record, climb, up.height, theory);
  draw_shoreline(run.record, history, theory, theory.law());
  draw_profiles(run.record, snapshots, cot_slope);
}

}  // namespace

Case run_up_1d() {
  Case c;
  c.title = "A solitary wave climbs a plane slope";
  c.source =
      "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 3.2; C. E. Synolakis, The "
      "runup of solitary waves, J. Fluid Mech. 185 (1987) 523";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = joined({{
                             real("cot_slope", 10.0, "1", {0.5, 50}, "cotangent of the slope"),
                             real("amplitude", 0.03, "depth", {1e-3, 0.6}, "height of the incident wave"),
                             real("time", 400.0, "sqrt(depth/g)", {1, 1e4}, "the run ends then at the latest"),
                         },
                         climb_parameters({0.25, 0.125, 0.0625}),
                         slope_parameters()});
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
