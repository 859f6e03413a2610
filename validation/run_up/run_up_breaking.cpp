/*
Water that runs back from a slope meets what still comes, and a bore forms. Synolakis (1987) gives the height of a
solitary wave above which that happens, $A > 0.479 (\cot\beta)^{-10/9}$. Frank's one-dimensional model keeps energy: it
cannot carry a bore, which loses some. This case shows where the model ends, and how.

**Set-up.** As in `run_up_1d`. Every run goes on through the run-down until the reflected wave has left, or until
markers cross or the water under one is gone: then the program stops with time, step and place of the failure. A switch
that the thesis does not have lets a compressed cell resist with the force $c_q V |\Delta u|/\Delta x$ times the
difference of velocities; it loses energy and keeps momentum.

**What is compared.** Nothing measured: waves above the limit are outside the model's validity, and their run-down is
not to be used. Claimed is that waves below the limit run through, that no run ends otherwise than with a stated
failure, and what the switch does.

**What to look at.** The map of slopes and heights, with the limit. Above it some waves run through with one spacing and
stop with another; with some the tip, a marker of almost no mass, shoots up when the bore reaches it. The first run-up
comes before all this and is not affected, but for $A = 0.3$ at cotangent 19.85, which breaks on its way up.
*/
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/run_up/run_down.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Role;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const std::string source = "Synolakis (1987); Frank (1994), chapter 3";

struct Wave {
  double cot_slope = 0;
  double amplitude = 0;
  [[nodiscard]] double over_limit() const { return amplitude / backwash_limit(cot_slope); }
};

/// The waves whose fate is told one by one.
const std::vector<Wave> told{{19.85, 0.0185}, {10, 0.03},     {10, 0.05}, {3.732, 0.1}, {3.732, 0.2},
                             {2.747, 0.193},  {2.747, 0.294}, {2, 0.195}, {2, 0.29},    {2, 0.41},
                             {2, 0.5},        {1, 0.195},     {1, 0.5},   {19.85, 0.3}};

struct Told {
  Wave wave;
  double spacing = 0;
  double breaking = 0;
  RunDown fate;
};

SolitaryClimb climb_of(const Values& values, Wave wave, double spacing, double breaking) {
  SolitaryClimb climb = climb_from(values, wave.cot_slope, wave.amplitude);
  climb.spacing = spacing;
  climb.breaking = breaking;
  return climb;
}

std::vector<Told> tell(Running& run) {
  std::vector<Told> all;
  const double spacing = run.real("h");
  for (const double breaking : {0.0, run.real("breaking")}) {
    for (const double h : {spacing, spacing / 2}) {
      for (const Wave& wave : told) {
        all.push_back({wave, h, breaking, run_down(climb_of(run.values(), wave, h, breaking))});
        run.progress(0.6 * static_cast<double>(all.size()) / static_cast<double>(4 * told.size()));
      }
    }
  }
  return all;
}

void tabulate(evidence::Record& record, const std::vector<Told>& all) {
  evidence::Table table{
      .id = "fates",
      .title = "Run-down of solitary waves, below and above the limit",
      .caption =
          "A over the limit; run-up; lowest shoreline and the highest after it; energy at the end over that of "
          "the start; how the run ended, time since the largest run-up. Above the limit only the run-up is to be "
          "used.",
      .columns = {{"cot", "1"},
                  {"A", "depth"},
                  {"A/limit", "1"},
                  {"h", "depth"},
                  {"switch", "1"},
                  {"run-up", "depth"},
                  {"lowest", "depth"},
                  {"later", "depth"},
                  {"energy", "1"},
                  {"end", ""}},
      .rows = {},
      .atlas = {}};
  using Cell = std::variant<double, std::string>;
  const auto rounded = [](double value) -> Cell {
    if (!std::isfinite(value)) return std::string();
    return std::round(value * 1e4) / 1e4;
  };
  for (const Told& one : all) {
    const RunDown& fate = one.fate;
    table.rows.push_back({one.wave.cot_slope, one.wave.amplitude, std::round(one.wave.over_limit() * 100) / 100,
                          one.spacing, one.breaking, rounded(fate.fell ? fate.runup : none),
                          rounded(fate.fell ? fate.lowest : none), rounded(fate.fell ? fate.later : none),
                          rounded(fate.energy),
                          fate.through() ? std::string("through")
                                         : fmt::format("stops at t = {:+.1f}, x = {:.2f}",
                                                       fate.failure_time - fate.runup_time, fate.failure_place)});
  }
  record.table(std::move(table));
}

/// Whether all that `which` selects are so.
template <class Which, class Is>
double all_are(const std::vector<Told>& all, const Which& which, const Is& is) {
  return std::all_of(all.begin(), all.end(), [&](const Told& one) { return !which(one) || is(one); }) ? 1.0 : 0.0;
}

void claim_fates(evidence::Record& record, const std::vector<Told>& all, const std::string& resolution) {
  const auto plain = [](const Told& one) { return one.breaking == 0; };
  const auto below = [&](const Told& one) { return plain(one) && one.wave.over_limit() < 1; };
  const auto through = [](const Told& one) { return one.fate.through(); };
  record.check({.id = "below",
                .text = "Waves below the limit run through run-up and run-down.",
                .quantity = "all do",
                .source = source},
               {.value = all_are(all, below, through), .resolution = resolution},
               evidence::Qualitative{.detector = "no failure until the reflected wave has left",
                                     .reason = "below 0.479 cot^(-10/9) no bore forms"});
  record.check(
      {.id = "stated",
       .text = "A run that stops says when and where, and its last state is sound.",
       .quantity = "all do",
       .source = source},
      {.value = all_are(
           all, [](const Told& one) { return !one.fate.through(); }, [](const Told& one) { return one.fate.sound; }),
       .resolution = resolution},
      evidence::Qualitative{.detector = "the failure's time and place are finite, the place is in the water, "
                                        "all markers and rates before it are finite",
                            .reason = "a failure must not pass as a result"});
  double later_below = 0;
  double later_above = 0;
  for (const Told& one : all) {
    if (!plain(one) || !one.fate.fell || !std::isfinite(one.fate.later)) continue;
    double& later = below(one) ? later_below : later_above;
    later = std::max(later, one.fate.later / one.fate.runup);
  }
  const evidence::Bound first_is_highest{.limit = 1,
                                         .reason =
                                             "the wave came once; what returns has lost energy to "
                                             "the reflected wave"};
  record.check({.id = "later-below",
                .text = "Below the limit the water never returns to the height of the first run-up.",
                .quantity = "largest later height of the shoreline over the run-up",
                .source = source},
               {.value = later_below, .resolution = resolution}, first_is_highest);
  record.known_failure(
      {.id = "later-above",
       .text = "Nor does it above the limit.",
       .quantity = "largest later height of the shoreline over the run-up",
       .source = source},
      {.value = later_above, .resolution = resolution}, first_is_highest,
      "the bore of the run-down meets the tip, a marker of almost no mass, and throws it up the slope; "
      "such runs may even go through: above the limit nothing after the first run-up is to be used");
}

/// What the switch does and what it does not, run by run against the same without it.
void claim_switch(evidence::Record& record, const std::vector<Told>& all, const std::string& resolution) {
  const std::size_t half = all.size() / 2;  // the second half is the first with the switch
  const auto is = [](Wave wave, double cot_slope, double amplitude) {
    return wave.cot_slope == cot_slope && wave.amplitude == amplitude;
  };
  double rescued = 1;
  double worst_energy = 0;
  double later = 0;
  double change_below = 0;
  double change_above = 0;
  for (std::size_t k = 0; k < half; ++k) {
    const Told& without = all[k];
    const Told& with = all[half + k];
    if ((is(with.wave, 10, 0.05) || is(with.wave, 3.732, 0.2)) && !with.fate.through()) rescued = 0;
    worst_energy = std::max(worst_energy, with.fate.energy - 1);
    if (!with.fate.through()) later = std::numeric_limits<double>::infinity();
    if (with.fate.fell && std::isfinite(with.fate.later)) later = std::max(later, with.fate.later / with.fate.runup);
    if (!with.fate.fell || !without.fate.fell) continue;
    double& change = with.wave.over_limit() < 1 ? change_below : change_above;
    change = std::max(change, std::abs(with.fate.runup / without.fate.runup - 1));
  }
  record.measure("switch_changes_runup_below_limit", change_below);
  record.measure("switch_changes_runup_above_limit", change_above);
  const std::string own = "the switch is not in the thesis";
  record.check({.id = "switch",
                .text = "With the switch the waves A = 0.05 at cotangent 10 and A = 0.2 at 3.732 run through.",
                .quantity = "both do, with both spacings",
                .source = own},
               {.value = rescued, .resolution = resolution},
               evidence::Qualitative{.detector = "no failure until the reflected wave has left",
                                     .reason = "the bore's energy goes where it should: it is lost"});
  record.check({.id = "switch-energy",
                .text = "The switch takes energy and never gives any.",
                .quantity = "largest energy at the end over that of the start, less 1",
                .source = own},
               {.value = worst_energy, .resolution = resolution},
               evidence::Bound{.limit = 0, .reason = "its forces oppose the rate of compression", .expected = 0});
  record.known_failure({.id = "switch-all",
                        .text = "With the switch every wave runs through, and none returns higher than it came.",
                        .quantity = "largest later height of the shoreline over the run-up; infinite where a run stops",
                        .source = own},
                       {.value = std::isfinite(later) ? later : 1e9, .resolution = resolution},
                       evidence::Bound{.limit = 1, .reason = "the wave came once"},
                       "strong bores still throw the light tip up the slope (A = 0.5 at cotangent 2), or stop the run "
                       "(A = 0.3 at 19.85; where it goes through, it climbs ten times its height, which is wrong)");
  record.known_failure({.id = "switch-neutral",
                        .text = "The switch leaves the first run-up as it is.",
                        .quantity = "largest relative change of the run-up",
                        .source = own},
                       {.value = std::max(change_below, change_above), .resolution = resolution},
                       evidence::Bound{.limit = 0.006, .reason = "to what the run-up is converged, see run_up_table"},
                       "it resists compression in the climbing front too; on the steepest slope the run-up changes by "
                       "several per cent, and the switch is off by default");
}

/// Fates over slopes and heights in units of the limit.
void draw_map(Running& run) {
  const std::vector<double> slopes{1, 1.5, 2, 2.747, 3.732, 5, 7, 10};
  const std::vector<double> ratios{0.7, 0.85, 0.99, 1.2, 1.5, 2, 3};
  constexpr double highest = 0.6;  // there are no much higher solitary waves
  struct Marks {
    std::vector<double> cot_slope;
    std::vector<double> amplitude;
  };
  Marks through;
  Marks shoots;
  Marks stops;
  bool all_below = true;
  double done = 0;
  for (const double cot_slope : slopes) {
    for (const double ratio : ratios) {
      const Wave wave{cot_slope, ratio * backwash_limit(cot_slope)};
      run.progress(0.6 + 0.4 * ++done / static_cast<double>(slopes.size() * ratios.size()));
      if (wave.amplitude > highest) continue;
      const RunDown fate = run_down(climb_of(run.values(), wave, run.real("h"), 0));
      const bool shot = fate.through() && fate.later > fate.runup;
      Marks& marks = !fate.through() ? stops : shot ? shoots : through;
      marks.cot_slope.push_back(cot_slope);
      marks.amplitude.push_back(wave.amplitude);
      if (ratio < 1 && (!fate.through() || shot)) all_below = false;
    }
  }
  run.record.check({.id = "map-below",
                    .text = "On all slopes of the map waves below the limit run through and return lower than they "
                            "came.",
                    .quantity = "all do",
                    .source = source},
                   {.value = all_below ? 1.0 : 0.0, .resolution = fmt::format("h = {:g}", run.real("h"))},
                   evidence::Qualitative{.detector = "no failure, no later height above the run-up",
                                         .reason = "below 0.479 cot^(-10/9) no bore forms"});
  auto& panel = run.record
                    .figure("map", "Where the model ends",
                            "Runs through run-up and run-down. Synolakis' limits: of run-down, 0.479 cot^(-10/9), and "
                            "of run-up, 0.8183 cot^(-10/9).")
                    .panel({.x = "cotangent of the slope", .y = "A [depth]", .log_x = true, .log_y = true});
  std::vector<double> limit;
  std::vector<double> up_limit;
  for (const double cot_slope : slopes) {
    limit.push_back(backwash_limit(cot_slope));
    up_limit.push_back(0.8183 / 0.479 * limit.back());
  }
  panel.line("breaks running back", slopes, limit, Role::exact);
  panel.line("breaks running up", slopes, up_limit, Role::guide);
  const auto points = [&](const std::string& label, const Marks& marks, Role role) {
    if (!marks.cot_slope.empty()) panel.points(label, marks.cot_slope, marks.amplitude, role);
  };
  points("runs through", through, Role::computed);
  points("runs through, tip shoots up", shoots, Role::peer);
  points("stops", stops, Role::data);
}

void run(Running& run) {
  const std::vector<Told> all = tell(run);
  const std::string resolution = fmt::format("h = {0:g} and {1:g}", run.real("h"), run.real("h") / 2);
  tabulate(run.record, all);
  for (const bool with : {false, true}) {
    run.record.measure(with ? "stopped_with_switch" : "stopped",
                       static_cast<double>(std::count_if(all.begin(), all.end(), [&](const Told& one) {
                         return (one.breaking > 0) == with && !one.fate.through();
                       })));
  }
  claim_fates(run.record, all, resolution);
  claim_switch(run.record, all, resolution);
  draw_map(run);
}

}  // namespace

Case run_up_breaking() {
  Case c;
  c.title = "Where the run-down breaks: the end of the model's validity";
  c.source =
      "C. E. Synolakis, The runup of solitary waves, J. Fluid Mech. 185 (1987) 523; A. M. Frank, Discrete models of "
      "incompressible fluid, doctoral thesis (1994), chapter 3";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = joined({climb_parameters({0.25, 0.125, 0.125}),
                         slope_parameters(),
                         {real("breaking", 2.0, "1", {0.1, 10}, "strength of the switch where it is on")}});
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
