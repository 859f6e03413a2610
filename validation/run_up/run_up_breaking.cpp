/*
Water running back from a slope meets the rest of the incident wave, and a bore forms. Synolakis (1987) gives the height
of a solitary wave above which this happens, $A > 0.479 (\cot\beta)^{-10/9}$. Frank's one-dimensional model conserves
energy and cannot represent a bore, which loses energy. The case shows where, and how, the model ends.

**Set-up.** As in `run_up_1d`. Every run continues through the run-down until the reflected wave has left, or until
nodes cross or a column runs dry: the program then stops with time, step and position of the failure.

**What is compared.** No measurement: waves above the limit are outside the validity of the model, and their run-down is
not to be used. The claims are that waves below the limit complete, and that every other run ends with a stated failure.

**What to look at.** The map of slopes and heights, with the limit. Above it some waves complete at one spacing and stop
at another; in some the tip, a node of almost no mass, shoots up when the bore reaches it. The first run-up precedes all
this and is not affected, except for $A = 0.3$ on the 1:19.85 beach, where the wave breaks on its way up.
*/
#include <algorithm>
#include <cmath>
#include <ranges>
#include <span>
#include <string>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "seiche/samples.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/each.hpp"
#include "validation/instruments/peak.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases::run_up_breaking {

// What becomes of a solitary wave that has climbed a slope and runs back, until the reflected wave has left or the run
// fails.

struct RunDown {
  double runup = nan;         ///< first maximum; NaN where it was not passed
  double runup_time = nan;    ///< of the highest shoreline, since the start
  bool fell = false;          ///< that maximum was passed
  double lowest = nan;        ///< of the shoreline after it
  double later = nan;         ///< highest of the shoreline from then on
  double energy = nan;        ///< at the end, over that of the start
  bool through = true;        ///< nothing failed
  double failure_time = nan;  ///< since the start
  double failure_place = nan;
  bool sound = true;  ///< the state before the failure is finite, and the place of failure in its water
};

bool in_the_water(const dispersive::Flow& flow, double place) {
  const auto finite = [](std::span<const double> values) { return std::isfinite(worst(values)); };
  const double cell = flow.x()[1] - flow.x()[0];
  return finite(flow.x()) && finite(flow.y()) && finite(flow.p()) && finite(flow.r()) &&
         place >= flow.x().front() - cell && place <= largest(flow.x()) + cell;
}

/// Follows a wave up and down the slope until the reflected wave is away; a Divergence becomes the result's failure.
RunDown run_down(const SolitaryClimb& climb) {
  constexpr double fallen = 0.9;
  const double end = climb.time_to(-climb.cot_slope) + 5 * climb.cot_slope + 20;  // up, down and away
  RunDown fate;
  dispersive::Flow flow = climb.start();
  const double energy = flow.energy();
  Peak edge;
  Smallest lowest;
  Largest later;  // from the lowest on
  try {
    while (flow.time() < end) {
      flow.advance(climb.step(flow));
      const double shoreline = flow.y().back();
      if (!fate.fell) {
        edge.add(flow.time(), shoreline);
        fate.fell = edge.value() > climb.amplitude && shoreline < fallen * edge.value();
      } else if (lowest.count() == 0 || shoreline < lowest.value()) {
        lowest.add(shoreline);
        later = {};
      }
      if (lowest.count() > 0) later.add(shoreline);
    }
  } catch (const Divergence& failure) {
    fate.through = false;
    fate.failure_time = failure.time();
    fate.failure_place = failure.place();
    fate.sound = std::isfinite(failure.time()) && in_the_water(flow, failure.place());
  }
  if (fate.fell) fate.runup = edge.value();
  fate.runup_time = edge.time();
  fate.lowest = lowest.value();
  fate.later = later.value();
  fate.energy = flow.energy() / energy;
  return fate;
}

const std::string source = "Synolakis (1987); Frank (1994), chapter 3";

struct Wave {
  double cot_slope = 0;
  double amplitude = 0;
  [[nodiscard]] double over_limit() const { return amplitude / backwash_limit(cot_slope); }
  /// Far above the limit of run-up, 0.8183 cot^(-10/9), the front breaks long before the shore: there is no first
  /// run-up to speak of.
  [[nodiscard]] bool climbs() const { return over_limit() < 2 * 0.8183 / 0.479; }
};

/// The waves whose fate is told one by one.
const std::vector<Wave> told{{19.85, 0.0185}, {10, 0.03},     {10, 0.05}, {3.732, 0.1}, {3.732, 0.2},
                             {2.747, 0.193},  {2.747, 0.294}, {2, 0.195}, {2, 0.29},    {2, 0.41},
                             {2, 0.5},        {1, 0.195},     {1, 0.5},   {19.85, 0.3}};

struct Told {
  Wave wave;
  double spacing = 0;
  RunDown fate;

  [[nodiscard]] bool below() const { return wave.over_limit() < 1; }
  /// Runs through and returns lower than it came.
  [[nodiscard]] bool returns_lower() const { return fate.through && fate.later <= fate.runup; }
};

Told tell(const Run& run, const Wave& wave, double spacing) {
  return {wave, spacing, run_down(climb_from(run, wave.cot_slope, wave.amplitude, spacing))};
}

/// All with two spacings.
std::vector<Told> tell_all(const Run& run) {
  std::vector<Told> all;
  for (const double part : {1.0, 2.0}) {
    for (const Wave& wave : told) {
      all.push_back(tell(run, wave, run.real("h") / part));
      run.progress(0.6 * static_cast<double>(all.size()) / static_cast<double>(2 * told.size()));
    }
  }
  return all;
}

const std::vector<double> mapped_slopes{1, 1.5, 2, 2.747, 3.732, 5, 7, 10};

/// The map of slopes and heights.
std::vector<Told> map_fates(const Run& run) {
  const std::vector<double> ratios{0.7, 0.85, 0.99, 1.2, 1.5, 2, 3};  // to the limit
  constexpr double highest = 0.6;                                     // there are no much higher solitary waves
  std::vector<Told> all;
  double done = 0;
  for (const double cot_slope : mapped_slopes) {
    for (const double ratio : ratios) {
      const Wave wave{cot_slope, ratio * backwash_limit(cot_slope)};
      run.progress(0.6 + 0.4 * ++done / static_cast<double>(mapped_slopes.size() * ratios.size()));
      if (wave.amplitude <= highest) all.push_back(tell(run, wave, run.real("h")));
    }
  }
  return all;
}

struct Results {
  std::vector<Told> told;
  std::vector<Told> map = {};
};

void tabulate(evidence::Exhibit& exhibit, const std::vector<Told>& all) {
  evidence::Table& table =
      add_table(exhibit, "fates", "Run-down of solitary waves, below and above the limit",
                "A over the limit; run-up; minimum shoreline elevation and the maximum after it; final over initial "
                "energy; end of the run, time since the maximum run-up. Above the limit only the run-up is valid.",
                {"cot [1]", "A [depth]", "A/limit [1]", "h [depth]", "run-up [depth]", "lowest [depth]",
                 "later [depth]", "energy [1]", "end"});
  for (const Told& one : all) {
    const RunDown& fate = one.fate;
    table.rows.push_back({one.wave.cot_slope, one.wave.amplitude, std::round(one.wave.over_limit() * 100) / 100,
                          one.spacing, rounded(fate.runup), rounded(fate.fell ? fate.lowest : nan),
                          rounded(fate.fell ? fate.later : nan), rounded(fate.energy),
                          fate.through ? Cell("through")
                                       : fmt::format("stops at t = {:+.1f}, x = {:.2f}",
                                                     fate.failure_time - fate.runup_time, fate.failure_place)});
  }
}

/// Whether all that `which` selects are so.
auto all_are(std::vector<Told> Results::*list, bool (*which)(const Told&), bool (*is)(const Told&)) {
  return [=](const Results& r) {
    return std::ranges::all_of(r.*list, [&](const Told& one) { return !which(one) || is(one); });
  };
}

/// Later heights of the shoreline over the run-up, of waves that climb.
template <class Samples, class... Property>
Samples later_heights(const std::vector<Told>& all, bool under, const Property&... property) {
  Samples samples;
  for (const Told& one : all) {
    if (one.wave.climbs() && one.below() == under) samples.add(one.fate.later / one.fate.runup, property...);
  }
  return samples;
}

void claim_fates(const Claims<Results>& claims, bool quick) {
  claims.check("below", "Run-up and run-down complete for all waves below the limit 0.479 cot^(-10/9).", "all do",
               all_are(
                   &Results::told, [](const Told& one) { return one.below(); },
                   [](const Told& one) { return one.fate.through; }),
               Qualitative{.detector = "no failure until the reflected wave has left",
                           .reason = "below 0.479 cot^(-10/9) no bore forms"});
  claims.check("stated", "The failure message of a stopped run gives time and position, and its last state is finite.",
               "all do",
               all_are(
                   &Results::told, [](const Told& one) { return !one.fate.through; },
                   [](const Told& one) { return one.fate.sound; }),
               Qualitative{.detector = "time and position of the failure are finite, the position is in the water, all "
                                       "nodes and rates before it are finite",
                           .reason = "a failure must not pass as a result"});
  claims.check(
      "later-below", "The later shoreline elevation below the limit stays below 1.0 times the first run-up.",
      "largest later shoreline elevation over the run-up",
      [](const Results& r) { return later_heights<Largest>(r.told, true).value(); },
      Bound{.limit = 1,
            .reason = "the incident wave is single, and the returning wave has lost energy to the reflected one"});
  claims
      .fails({.value = quick ? 6.0 : 3.0,
              .width = 1,
              .reason = "the bore of the run-down meets the tip, a node of almost no mass, and throws it up the slope; "
                        "such runs may even complete: above the limit results after the first run-up are invalid. At "
                        "finer spacings more of the runs stop earlier"})
      .check(
          "later-above",
          "The number of runs above the limiting amplitude whose shoreline later exceeds its first run-up is zero.",
          "runs whose shoreline later stands above the run-up",
          [](const Results& r) {
            return later_heights<Count>(r.told, false, [](double ratio) { return ratio > 1; }).value();
          },
          Bound{.limit = 0,
                .reason = "the incident wave is single, and the returning wave has lost energy to the reflected one"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  const double h = values.real("h");
  const bool quick = values.tier() == Tier::quick;
  claim_fates(claims.at(fmt::format("h = {0:g} and {1:g}", h, h / 2)), quick);
  claims.at(fmt::format("h = {:g}", h))
      .check("map-below",
             "The later shoreline elevation of all waves of the map below the limit stays below the first run-up.",
             "all do",
             all_are(
                 &Results::map, [](const Told& one) { return one.below(); },
                 [](const Told& one) { return one.returns_lower(); }),
             Qualitative{.detector = "no failure, no later height above the run-up",
                         .reason = "below 0.479 cot^(-10/9) no bore forms"});
}

Results compute(const Run& run) {
  Results r{.told = tell_all(run)};
  r.map = map_fates(run);
  return r;
}

/// Fates over slopes and heights in units of the limit.
void draw_map(evidence::Exhibit& exhibit, const std::vector<Told>& map) {
  auto& panel = add_panel(exhibit, "map", "Limit of the model",
                          "Completed run-up and run-down. Synolakis' limits: of run-down, 0.479 cot^(-10/9), and of "
                          "run-up, 0.8183 cot^(-10/9).",
                          {.x = "s of the slope 1:s", .y = "A [depth]", .log_x = true, .log_y = true});
  const auto limit = each(mapped_slopes, backwash_limit);
  panel.line("breaks in run-down", mapped_slopes, limit, Role::exact);
  panel.line("breaks in run-up", mapped_slopes, each(limit, [](double a) { return 0.8183 / 0.479 * a; }), Role::guide);
  const auto points = [&](const std::string& label, Role role, const auto& is) {
    auto those = map | std::views::filter(is);
    if (those.empty()) return;
    panel.points(label, each(those, [](const Told& one) { return one.wave.cot_slope; }),
                 each(those, [](const Told& one) { return one.wave.amplitude; }), role);
  };
  points("runs through", Role::computed, &Told::returns_lower);
  points("completes, tip shoots up", Role::peer,
         [](const Told& one) { return one.fate.through && !one.returns_lower(); });
  points("stops", Role::data, [](const Told& one) { return !one.fate.through; });
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  tabulate(exhibit, r.told);
  exhibit.measure(
      "stopped", static_cast<double>(std::ranges::count_if(r.told, [](const Told& one) { return !one.fate.through; })));
  exhibit.measure("largest_later_over_runup_above_limit", later_heights<Largest>(r.told, false).value());
  draw_map(exhibit, r.map);
}

void run_up_breaking(Case& c) {
  c.title = "Breaking in run-down: limit of the dispersive model";
  c.source = literature::synolakis + "; " + literature::frank + ", chapter 3";
  c.parameters = joined({climb_parameters({0.25, 0.125, 0.125}), slope_parameters()});
  c.study = Study(claims, compute, show, source);
}

}  // namespace seiche::validation::cases::run_up_breaking
