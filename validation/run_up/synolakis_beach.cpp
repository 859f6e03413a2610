/*
Synolakis (1987) photographed solitary waves on a 1:19.85 plane beach. His profiles of a non-breaking wave, $A =
0.0185$, and his exact solution of the shallow-water equations for $A = 0.019$ are the standard benchmark of tsunami
models. Frank (1994, figure 5) shows his one-dimensional discrete model beside them.

**Set-up.** As in `run_up_1d`. Time counts, as in the measurements, from the instant at which the crest of the
undisturbed wave is $\operatorname{arccosh}(\sqrt{20})/\sqrt{3A/4}$ before the toe. Where the model is dry its surface
is the beach.

**What is compared.** Profiles with the exact solution and with the laboratory. A wave of $A = 0.3$, which breaks in the
laboratory and which no model without dissipation can follow: the time reached depends on the spacing. With breaking
fronts and the friction of a smooth bed, Manning's $n$ = 0.009 s/m$^{1/3}$ at the experiment's depth of 0.156 m or 0.038
in these units, the wave is followed and compared. For the run-up see `synolakis_runup`.

**Your solver.** The exact solution, NTHMP benchmark problem 1: surfaces from $t = 35$ to 70, gauges at $x = 0.25$ and
9.95, and the run-up of $A = 0.019$, all over depth and $\sqrt{d/g}$, $x$ from the still-water shoreline, positive
offshore. For the laboratory, problem 4, see `plane_beach`.

The thesis draws the instants $t$ = 30, 40, 50, 60 and 70, and prints no number.

**What to look at.** At $t = 70$ the water runs back in a thin tongue, where the laboratory, with bed friction, and
frictionless flow differ. Elsewhere the model is nearer to the measurements than the shallow-water equations.
*/
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "seiche/divergence.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_source.hpp"
#include "validation/instruments/fine_limit.hpp"
#include "validation/run_up/beach_profiles.hpp"
#include "validation/run_up/solitary_climb.hpp"

namespace seiche::validation::cases::synolakis_beach {

using dispersive::Flow;

constexpr double cot_slope = beach_cot_slope;
constexpr double laboratory_amplitude = 0.0185;
constexpr double theory_amplitude = beach_theory_amplitude;
constexpr double breaking_amplitude = 0.3;
const std::string source = "Synolakis (1987)";

/// The model's surfaces at the times of a table of profiles, as far as it gets.
struct Followed {
  double spacing = 0;
  Profiles surfaces;
  std::optional<double> stopped;  ///< when markers crossed or the water was gone
};

Followed follow(const SolitaryClimb& climb, const Profiles& reference) {
  constexpr double gauge_fraction = 1.0 / 20;
  const double begin = climb.time_to(-cot_slope - climb.reach(gauge_fraction));
  Followed followed{.spacing = climb.spacing};
  Flow flow = climb.start();
  try {
    for (const auto& [t, unused] : reference) {
      climb.advance_to(flow, begin + t);
      Surface& surface = followed.surfaces[t];
      for (std::size_t i = flow.x().size(); i-- > 0;) {
        surface.x.push_back(-flow.x()[i]);
        surface.y.push_back(flow.y()[i]);
      }
    }
  } catch (const Divergence& failure) {
    followed.stopped = failure.time() - begin;
  }
  return followed;
}

Worst farthest(const Differences& profiles) {
  Worst worst;
  for (const auto& [t, d] : profiles) worst.add(d.off.rms(), t);
  return worst;
}

/// The laboratory's distance from the model and from the exact solution: that was tabulated for another wave and is
/// scaled by the ratio of heights.
struct AsNear {
  std::map<double, double> theory;  ///< rms by time
  double by_model = 0;              ///< sum of squares of the profiles' rms
  double by_theory = 0;

  [[nodiscard]] double ratio() const { return std::sqrt(by_model / by_theory); }
};

AsNear as_near(const Profiles& laboratory, const Profiles& model, const Profiles& analytic) {
  AsNear result;
  for (const auto& [t, measured] : laboratory) {
    if (!analytic.contains(t)) continue;
    const double theory = difference(analytic.at(t), measured, laboratory_amplitude / theory_amplitude).off.rms();
    result.theory[t] = theory;
    result.by_theory += theory * theory;
    result.by_model += std::pow(model.contains(t) ? difference(model.at(t), measured).off.rms() : nan, 2);
  }
  return result;
}

/// A = 0.3, ten times the height that breaks on the way up.
std::vector<Followed> follow_breaking(const Run& run, const Profiles& laboratory) {
  constexpr double fine_step = 1.0 / 16;  // of the spacing: the front is steep
  std::vector<Followed> all;
  for (const double spacing : {0.5, 0.25, 0.125}) {
    SolitaryClimb climb = climb_from(run, cot_slope, breaking_amplitude, spacing);
    climb.tau_over_spacing = fine_step;
    all.push_back(follow(climb, laboratory));
  }
  return all;
}

/// The same wave with breaking and friction, to the end of the run-down.
Followed follow_closure(const Run& run, const Profiles& laboratory) {
  SolitaryClimb climb = climb_from(run, cot_slope, breaking_amplitude, 0.125);
  climb.kinetics = dispersive::Kinetics::green_naghdi;
  climb.tip_mass = dispersive::TipMass::consistent;
  climb.friction = {dispersive::FrictionLaw::manning, 0.038};
  climb.breaking = dispersive::Breaking{};
  Profiles wanted = laboratory;
  wanted[80] = {};
  return follow(climb, wanted);
}

/// Whether every halving of the spacing lets the run stop no later, and the last one does stop it.
bool stop_ever_earlier(const std::vector<Followed>& all) {
  const auto later = [](const Followed& coarse, const Followed& fine) {
    return coarse.stopped && !(fine.stopped && *fine.stopped <= *coarse.stopped);
  };
  return all.back().stopped && std::ranges::adjacent_find(all, later) == all.end();
}

struct Results {
  Profiles laboratory;
  Profiles analytic;
  Profiles breaking_laboratory;
  Profiles with_laboratory;  ///< the model's surfaces
  Profiles with_theory;
  Differences off_laboratory;
  std::vector<double> spacing;   ///< this and coarser ones
  std::vector<double> distance;  ///< with each of them, largest from the laboratory
  Differences off_analytic;
  AsNear nearness;
  std::vector<Followed> breaking;
  Followed closure;
};

void draw_profiles(evidence::Exhibit& exhibit, const Profiles& laboratory, const Profiles& analytic,
                   const Profiles& model) {
  auto& figure = exhibit.figure("frank_fig_5", "Run-up on a beach 1 : 19.85",
                                "Model and exact solution of the shallow-water equations, A = 0.019; measured, A = "
                                "0.0185. Abscissa: distance from the shoreline at rest, positive offshore.",
                                {"frank-fig-5"});
  for (const auto& [t, surface] : laboratory) {
    auto& panel = figure.panel({.x = "x [depth]",
                                .y = "elevation [depth]",
                                .title = fmt::format("t = {:g}", t),
                                .x_min = -2,
                                .x_max = 20,
                                .y_min = -0.05,
                                .y_max = 0.1});
    panel.fill("beach", std::vector{-2.0, 20.0}, std::vector{2 / cot_slope, -20 / cot_slope}, Role::bed);
    panel.points("laboratory", surface.x, surface.y, Role::data);
    if (analytic.contains(t)) panel.line("shallow-water equations", analytic.at(t).x, analytic.at(t).y, Role::exact);
    if (model.contains(t)) panel.line("model", model.at(t).x, model.at(t).y, Role::computed);
  }
}

void draw_breaking_wave(evidence::Exhibit& exhibit, const Profiles& laboratory, const std::vector<Followed>& runs,
                        const Profiles& closure) {
  auto& figure = exhibit.figure(
      "breaking_wave", "Wave breaking in the laboratory",
      "A = 0.3, outside the validity of the model without breaking. Curves end where the run with that spacing stops.");
  for (const auto& [t, measured] : laboratory) {
    auto& panel = figure.panel({.x = "x [depth]", .y = "elevation [depth]", .title = fmt::format("t = {:g}", t)});
    panel.points("laboratory", measured.x, measured.y, Role::data);
    const auto draw = [&, at = t, last = measured.x.back() + 2](const std::string& name, const Profiles& surfaces) {
      if (!surfaces.contains(at)) return;
      const Surface& surface = surfaces.at(at);
      const auto end = std::ranges::upper_bound(surface.x, last) - surface.x.begin();
      const auto shown = static_cast<std::size_t>(end);
      panel.line(name, std::span(surface.x).first(shown), std::span(surface.y).first(shown), Role::computed);
    };
    for (const Followed& run : runs) draw(fmt::format("model, h = {:g}", run.spacing), run.surfaces);
    draw("model with breaking, h = 0.125", closure);
  }
}

/// Tabulates every profile that was reached.
void tabulate(evidence::Table& table, const std::string& id, double amplitude, const Differences& profiles) {
  for (const auto& [t, d] : profiles) {
    if (d.off.count() == 0) continue;
    table.rows.push_back({id, amplitude, t, d.off.rms(), d.range, static_cast<double>(d.dry)});
  }
}

void claims(const Values& values, const Claims<Results>& claims) {
  const auto profiles = claims.at(climb_from(values, cot_slope, laboratory_amplitude).resolution());
  const auto analytic = profiles.of(&Results::off_analytic);
  analytic.check(all_profiles().claim, relative_distance, all_profiles().bound);
  analytic
      .fails({.value = 0.0533,
              .width = 0.0015,
              .reason = "at t = 65 the surface is nearly level and the wave, dispersive and faster than sqrt(g d), has "
                        "already left; the difference does not fall with the spacing"})
      .check(each_profile().claim, largest_over_range, each_profile().bound);
  analytic.from(literature::frank + ", figure 5")
      .check(
          "figure-profiles",
          "Each surface profile of figure 5 at t = 40 to 70 agrees with the exact shallow-water solution.",
          "largest rms distance over the range of the profile, t = 40, 50, 60, 70",
          [](const Differences& all) {
            Differences of_figure;
            for (const double t : {40.0, 50.0, 60.0, 70.0}) of_figure[t] = all.at(t);
            return largest_over_range(of_figure);
          },
          each_profile().bound);
  profiles
      .fails({.value = 0.0068,
              .width = 0.0003,
              .reason = "the exact shallow-water solution has an equal error: the incident wave in the laboratory is "
                        "not quite a solitary wave, and friction and surface tension retard the thin tongue"})
      .check(
          "laboratory-profiles",
          "Surface profiles at all times agree with the measurement within 5 % of the wave height.",
          "largest rms distance [depth]",
          [](const Results& r) -> Measurement {
            const Worst worst = farthest(r.off_laboratory);
            return {.value = worst.value(),
                    .uncertainty = fine_limit(r.spacing, r.distance, 1).uncertainty,
                    .where = fmt::format("t = {:g}", worst.where())};
          },
          Uncertainty{
              .data = reference_source("synolakis_1987_profiles_0_0185").standard_uncertainty.at("eta_over_d").value,
              .useful = 0.005,
              .reason = "gauge and repeatability, 5 % of the wave height (assumed)"});
  profiles.check(
      "as-near",
      "The rms difference of the model from the measured surface is at most the difference of the exact shallow-water "
      "solution.",
      "rms difference over the difference of the exact solution, t = 40 to 70",
      [](const Results& r) { return r.nearness.ratio(); },
      Bound{.limit = 1, .reason = "at most equal means a ratio of 1 or less"});
  claims.at("h = 0.5, 0.25, 0.125, tau = h/16")
      .check(
          "breaking-wave",
          "The time reached with a wave of A = 0.3 falls with the spacing: breaking is outside the validity of the "
          "model.",
          "runs stop earlier with each halving of the spacing",
          [](const Results& r) { return stop_ever_earlier(r.breaking); },
          Qualitative{.detector = "times at which nodes cross or a column runs dry",
                      .reason = "waves higher than 0.8183 cot^(-10/9) = 0.03 break on the way up; an energy-conserving "
                                "model cannot represent the bore"});
  const auto closure = claims.at("h = 0.125, breaking, friction");
  closure.check(
      "closure-follows", "The run with breaking and friction reaches t = 80, after run-up and run-down.",
      "runs to the end", [](const Results& r) { return !r.closure.stopped.has_value(); },
      Qualitative{.detector = "nodes cross or a column runs dry before t = 80",
                  .reason = "the front is a bore of finite width, and friction slows the tongue"});
  const auto distance = [](double t, const Results& r) {
    const Difference off = differences(r.closure.surfaces, r.breaking_laboratory).at(t);
    return off.off.rms() / off.range;
  };
  const std::string laboratory = "10 %, the tolerance of laboratory benchmarks in NOAA Tech. Memo. OAR PMEL-135 (2007)";
  const std::string ahead =
      "before breaking, at t = 15, the computed crest leads the measured one by 0.8 h and is 17 % higher: the wave in "
      "the laboratory is lower or slower than its nominal height";
  for (const double t : {15.0, 20.0, 25.0, 30.0}) {
    closure.fails({.value = t == 15 ? 0.15 : 0.192, .width = 0.01, .reason = ahead}, t <= 20)
        .check(
            fmt::format("closure-profile-{:g}", t),
            fmt::format("The surface at t = {:g} agrees with the measured profile (breaking, friction).", t),
            "rms distance over the range of the profile", [distance, t](const Results& r) { return distance(t, r); },
            Bound{.limit = 0.1, .reason = laboratory});
  }
}

Results compute(const Run& run) {
  Results r{.laboratory = profiles_of(run, "synolakis_1987_profiles_0_0185"),
            .analytic = profiles_of(run, "synolakis_1987_analytic_profiles"),
            .breaking_laboratory = profiles_of(run, "synolakis_1987_profiles_0_3")};
  Profiles wanted = r.analytic;
  for (const auto& [t, surface] : r.laboratory) wanted.try_emplace(t, surface);
  for (const double factor : {1.0, 2.0, 4.0}) {
    SolitaryClimb climb = climb_from(run, cot_slope, laboratory_amplitude);
    climb.spacing *= factor;
    Profiles surfaces = follow(climb, r.laboratory).surfaces;
    r.spacing.push_back(climb.spacing);
    r.distance.push_back(farthest(differences(surfaces, r.laboratory)).value());
    if (factor == 1) r.with_laboratory = std::move(surfaces);
  }
  r.with_theory = follow(climb_from(run, cot_slope, theory_amplitude), wanted).surfaces;
  run.progress(0.1);
  r.off_laboratory = differences(r.with_laboratory, r.laboratory);
  r.off_analytic = differences(r.with_theory, r.analytic);
  r.nearness = as_near(r.laboratory, r.with_laboratory, r.analytic);
  r.breaking = follow_breaking(run, r.breaking_laboratory);
  r.closure = follow_closure(run, r.breaking_laboratory);
  return r;
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  draw_profiles(exhibit, r.laboratory, r.analytic, r.with_theory);
  evidence::Table& table = add_table(exhibit, "profiles", "Difference of the profiles",
                                     "Root mean square over the reference points, the beach where the model is dry; "
                                     "range of the reference profile; reference points where the model is dry.",
                                     {"reference", "A [depth]", "t", "rms [depth]", "range [depth]", "dry [1]"});
  tabulate(table, "analytic", theory_amplitude, r.off_analytic);
  tabulate(table, "laboratory", laboratory_amplitude, r.off_laboratory);
  tabulate(table, "breaking", breaking_amplitude, differences(r.breaking.front().surfaces, r.breaking_laboratory));
  for (const auto& [t, theory] : r.nearness.theory) {
    exhibit.measure(fmt::format("rms_laboratory_of_theory_t{:g}", t), theory);
  }
  for (const Followed& one : r.breaking) {
    exhibit.measure(fmt::format("breaking_wave_stops_h_1_{:g}", 1 / one.spacing), one.stopped.value_or(nan));
  }
  draw_breaking_wave(exhibit, r.breaking_laboratory, r.breaking, r.closure.surfaces);
}

void synolakis_beach(Case& c) {
  c.title = "Run-up of solitary waves on a 1:19.85 beach: profiles against Synolakis' laboratory and theory";
  c.source = literature::frank + ", figure 5; " + literature::synolakis;
  c.parameters = joined({climb_parameters({0.25, 0.125, 0.0625}), slope_parameters()});
  c.published = {{.tiles = {"frank-fig-5"}, .stated = {"kinetics", "scheme"}}};
  c.study = Study(claims, compute, show, source);
  c.submission = beach_submission();
}

}  // namespace seiche::validation::cases::synolakis_beach
