/*
A flap hinged at the bed of a flume starts from rest and generates a regular wave, computed with weakly compressible SPH
(figure 5 of the publication). FlapDesign: depth $d = 4$ m, wavelength $L = 27.3$ m, height 1.02 m, stroke 2.11 m,
period 4.7 s.

**Set-up.** The flap rotates rigidly, $X_w = \tfrac12 S\sin\omega t$ at the still-water level. $\alpha = 0.01$, density
filter every 30 steps, $c_0 = 10\sqrt{gd}$. The flume is long enough to exclude reflections. Elevations at $x = L$:
where the volume fraction of water on the vertical falls to 0.5.

**What is compared.** Wave heights in each period with two references: the exact linear transient from rest,
`wavemaker_start`; and the design, from which the publication reports a difference of "about 8 per cent" for the second
wave, without an origin of time. Counted from the start of the flap, the second wave at $x = L$ is a third below the
design, in exact linear theory a fifth. Counted from one period later, when the wave is at the gauge, it is 5 to 12 %
below the design, depending on the spacing: this origin agrees.

**Where the loss is.** With the publication's cubic spline and $h = 1.3\,dx$ the second wave is too low. The table
follows it along the flume: beside the flap it equals the exact transient, so that the paddle is correct; on the way it
decays. Viscosity, density filter, XSPH, walls, sound speed and spacing are changed one at a time (tier `full`): none
restores much of the loss. The number of neighbours does, with a kernel that permits it: the Wendland kernel with $h =
1.7\,dx$, 36 neighbours instead of 21, at 1.3 times the cost, for its steps are longer. The cubic spline does not: at
that many neighbours its particles pair.

**What to look at.** In linear theory itself the first wave at $x = L$ is almost absent, the second more than 20 % too
low, the third too high. Period and wavelength of the design are inconsistent: with $T = 4.7$ s linear waves are 25.9 m
long and, for this stroke, 1.08 m high.
*/
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/wavemaker.hpp"
#include "seiche/models/wcsph/flow.hpp"
#include "seiche/samples.hpp"
#include "validation/case/literature.hpp"
#include "validation/instruments/agreement.hpp"
#include "validation/instruments/each.hpp"
#include "validation/studies/wcsph/spacing_ladder.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"
#include "validation/wavemaker/sph_flap_waves.hpp"

namespace seiche::validation::cases::flap_wave_sph {

const std::string publication = literature::plunging_sph + ", figure 5";
const std::string theory = "Kennard (1949); Dean and Dalrymple (1991), chapter 6";
const FlapScheme as_set{"as set", [](wcsph::Settings&) {}};
template <double smoothing>
void wendland(wcsph::Settings& s) {
  s.kernel = wcsph::KernelName::wendland_c2;
  s.smoothing = smoothing;
}
const FlapScheme more_neighbours{"Wendland kernel, h = 1.7 dx", wendland<1.7>};
const std::vector<FlapScheme> suspects{
    {"artificial viscosity 0.001", [](wcsph::Settings& s) { s.viscosity = wcsph::ArtificialViscosity{0.001}; }},
    {"unresolved eddies", [](wcsph::Settings& s) { s.viscosity = wcsph::LaminarSps{}; }},
    {"no density filter", [](wcsph::Settings& s) { s.filter_every = 0; }},
    {"density diffusion 0.1", [](wcsph::Settings& s) { s.density_diffusion = 0.1; }},
    {"no XSPH", [](wcsph::Settings& s) { s.xsph = 0; }},
    {"extrapolated wall pressure", [](wcsph::Settings& s) { s.walls = wcsph::WallPressure::extrapolated; }},
    {"sound speed doubled", [](wcsph::Settings& s) { s.sound_speed *= 2; }},
    {"cubic spline, h = 1.5 dx", [](wcsph::Settings& s) { s.smoothing = 1.5; }},
    {"Wendland kernel, h = 1.3 dx", [](wcsph::Settings& s) { s.kernel = wcsph::KernelName::wendland_c2; }},
    {"Wendland kernel, h = 1.5 dx", wendland<1.5>},
    {"Wendland kernel, h = 2 dx", wendland<2.0>}};

/// Linear theory at the places and instants at which the elevation is read.
struct Theory {
  std::vector<double> time, settled;  ///< settled at the gauge
  Elevations transient;
  std::array<std::array<double, 3>, places.size()> heights{};  ///< of the transient
  double settled_height = 0;
  double wavenumber = 0;

  /// k H/2 of the second wave at a place: the share by which waves of this height may differ from linear ones.
  [[nodiscard]] double steepness(std::size_t place) const { return 0.5 * wavenumber * heights[place][1]; }
};

Theory theory_of(const FlapDesign& design) {
  const exact::WavemakerTransient start(exact::Paddle::flap, {flap_gravity, design.depth}, exact::Period{design.period},
                                        design.stroke);
  Theory linear;
  for (long n = 0; n <= std::lround(flap_periods * samples_per_period); ++n) {
    const double t = design.period * static_cast<double>(n) / samples_per_period;
    linear.time.push_back(t);
    linear.settled.push_back(start.steady().elevation(design.gauge, t));
    for (std::size_t k = 0; k < places.size(); ++k) {
      linear.transient[k].push_back(start.elevation(places[k] * design.gauge, t));
    }
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    linear.heights[k] = heights_of(linear.time, linear.transient[k], design.period);
  }
  linear.settled_height = start.steady().wave_height();
  linear.wavenumber = 2 * std::numbers::pi / start.steady().wavelength();
  return linear;
}

constexpr std::size_t beside_flap = 0;
constexpr std::size_t at_gauge = places.size() - 1;

struct Results {
  FlapDesign design;
  Theory linear;
  std::vector<FlapWaves> runs;      ///< as set, by the lattices of the ladder
  std::vector<FlapWaves> wide;      ///< with more neighbours, by the same
  std::vector<FlapWaves> suspects;  ///< on the coarsest lattice

  [[nodiscard]] std::array<double, 3> heights(const FlapWaves& waves, std::size_t place = at_gauge) const {
    return heights_of(waves.time, waves.elevation[place], design.period);
  }

  /// How high the waves are at a place over those of the exact transient: roots of the mean square after one period.
  [[nodiscard]] double share(const FlapWaves& waves, std::size_t place) const {
    Mean computed, exact;
    for (std::size_t n = samples_per_period; n < linear.time.size(); ++n) {
      computed.add(std::pow(waves.elevation[place][n], 2));
      exact.add(std::pow(linear.transient[place][n], 2));
    }
    return std::sqrt(computed.value() / exact.value());
  }

  /// The part of it that is lost between the flap and the gauge.
  [[nodiscard]] double loss(const FlapWaves& waves) const {
    return 1 - share(waves, at_gauge) / share(waves, beside_flap);
  }
};

Results compute(const Run& run) {
  const FlapDesign design = flap_design(run);
  const std::vector<long> ladder = sph_ladder(run.tier(), run.integer("layers"));
  const std::size_t sizes = ladder.size();
  // Side by side, the costliest last, as climb() asks for it.
  const std::size_t changed = run.tier() == Tier::quick ? 0 : suspects.size();
  Results r{.design = design,
            .linear = theory_of(design),
            .runs = std::vector<FlapWaves>(sizes),
            .wide = std::vector<FlapWaves>(sizes),
            .suspects = std::vector<FlapWaves>(changed)};
  const auto waves = [&](long layers, const FlapScheme& scheme, bool may_break) {
    const Part part = run.part(fmt::format("{} layers, {}", layers, scheme.name));
    return part.result<FlapWaves>([&] { return make_flap_waves(run, design, layers, scheme, may_break, part); });
  };
  climb(run, changed + 2 * sizes, [&](std::size_t k) {
    const std::size_t size = k < changed ? 0 : (k - changed) / 2;
    if (k < changed) {
      r.suspects[k] = waves(ladder[size], suspects[k], true);
    } else if ((k - changed) % 2 == 0) {
      r.runs[size] = waves(ladder[size], as_set, false);
    } else {
      r.wide[size] = waves(ladder[size], more_neighbours, false);
    }
  });
  return r;
}

/// Resolution of the finest lattice.
auto by(std::vector<FlapWaves> Results::*runs) {
  return [runs](const Results& r) { return (r.*runs).back().resolution(); };
}

void claim_scheme(const Claims<Results>& all, const std::string& id, const FlapScheme& scheme,
                  std::vector<FlapWaves> Results::*runs, const Theory& linear) {
  const auto claims = all.at(by(runs));
  claims.check(
      "beside-flap" + id,
      fmt::format("The height of the second wave beside the flap agrees with the exact transient ({}).", scheme.name),
      "height from crest to trough during the second period [m]",
      [runs](const Results& r) { return r.heights((r.*runs).back(), beside_flap)[1]; },
      Bound{.limit = linear.steepness(beside_flap),
            .reason = "nonlinearity: k H/2 of this wave",
            .expected = linear.heights[beside_flap][1],
            .relative = true});
  claims.from(publication)
      .check(
          "contained" + id,
          fmt::format("The number of particles behind the flap or through a wall is zero ({}).", scheme.name),
          "particles outside at the end", [runs](const Results& r) { return (r.*runs).back().behind; },
          Bound{.limit = 0, .reason = "walls are impermeable"});
}

void claim_loss(const Claims<Results>& all, const Theory& linear, const Values& values) {
  const auto claims = all.at(by(&Results::wide));
  // FlapWaves are highest, and linear theory errs most, beside the flap.
  const double nonlinear = linear.steepness(beside_flap);
  claims.check(
      "loss-more",
      fmt::format(
          "The loss of wave height between flap and gauge is at most k H/2, the nonlinearity beside the flap ({}).",
          more_neighbours.name),
      "fraction of height lost between flap and gauge, against the exact transient",
      [](const Results& r) { return r.loss(r.wide.back()); },
      Bound{.limit = nonlinear, .reason = "nonlinearity: k H/2 beside the flap, where waves are highest"});
  const auto few = all.at(by(&Results::runs))
                       .only_if(values.text("kernel") == "cubic_spline" && values.real("smoothing") <= 1.3,
                                "stated for the publication's kernel and number of neighbours");
  few.check(
      "loss", "The loss of wave height with the publication's 21 neighbours exceeds the nonlinearity k H/2.",
      "exceeds the nonlinearity", [nonlinear](const Results& r) { return r.loss(r.runs.back()) > nonlinear; },
      Qualitative{
          .detector = "fraction of height lost between flap and gauge above k H/2",
          .reason = "the viscosity of the settings, 0.08 alpha c h, dissipates 1 % of the height over this distance"});
  const double wider = 1.7 / values.real("smoothing");
  few.at(by(&Results::wide))
      .only_if(values.real("smoothing") >= 1.25,
               "shells of fewer neighbours are not proportional to the area of the support")
      .check(
          "cheap",
          fmt::format("The neighbour pairs of the wider kernel, which restores the height, grow with its smoothing "
                      "length within 20 % ({}).",
                      more_neighbours.name),
          "pairs of neighbours evaluated in the run, over those as set",
          [](const Results& r) {
            return static_cast<double>(r.wide.back().extremes.interactions) /
                   static_cast<double>(r.runs.back().extremes.interactions);
          },
          Bound{.limit = 0.2,
                .reason = "neighbours scale with h^2 and steps with 1/h, hence pairs with h; neighbours come in "
                          "shells, which a flow dissolves: 20 %",
                .expected = wider,
                .relative = true});
  few.only_if(sph_ladder(values.tier(), values.integer("layers")).size() >= 3, "needs the spacings of the full tier")
      .check(
          "not-spacing",
          "The loss of wave height at half the spacing exceeds half of the loss at the full spacing (settings of the "
          "publication).",
          "half the spacing leaves more than half of the loss",
          [](const Results& r) { return r.loss(r.runs.back()) > 0.5 * r.loss(r.runs.front()); },
          Qualitative{
              .detector = "fraction lost at the finest spacing above half of that at the coarsest, twice as large",
              .reason = "a first-order error would be halved"});
}

void claim_variants(const Claims<Results>& claims, const Values& values) {
  const auto all = claims.at([](const Results& r) { return r.suspects.front().resolution(); })
                       .only_if(values.tier() != Tier::quick, "variants run from the full tier on");
  all.fails(
         {1, 0, "with extrapolated wall pressure the density of a particle leaves [0.5, 1.5] at 2.55 s with 40 layers"},
         sph_ladder(values.tier(), values.integer("layers")).front() >= 40)
      .from(publication)
      .check(
          "variants", "The number of variants of the scheme that break down is zero.", "variants that break down",
          [](const Results& r) {
            return std::ranges::count_if(r.suspects, [](const FlapWaves& w) { return std::isfinite(w.breaks_down); });
          },
          Bound{.limit = 0, .reason = "a count"});
}

/// What the publication says of the second wave, by the clocks that it may count with.
void claim_design(const Claims<Results>& all, const FlapDesign& design) {
  constexpr double height = 1.02;  // of the design [m]
  constexpr double said = 0.08;
  const auto lower = [](std::size_t period) {
    return [period](const Results& r) { return 1 - r.heights(r.runs.back())[period] / height; };
  };
  const auto claims =
      all.at(by(&Results::runs))
          .only_if(design.depth == 4 && design.period == 4.7 && design.stroke == 2.11 && design.gauge == 27.3,
                   "stated for the publication's wave")
          .from(publication);
  claims.check("second-from-gauge",
               "The height of the second wave, counted from one period after the start, is about 8 % below the design, "
               "as in the publication.",
               "deficit of the second wave relative to the design height 1.02 m", lower(2),
               Bound{.limit = said / 2, .reason = "\"about\" interpreted as within half of it", .expected = said});
  claims.check(
      "second-from-start",
      "The height of the second wave, counted from the start of the flap, is more than 12 % below the design, which "
      "excludes this origin of time.",
      "the deficit is larger", [at = lower(1)](const Results& r) { return at(r) > 1.5 * said; },
      Qualitative{.detector = "more than 12 % of the design height",
                  .reason = "the deficit in exact linear theory is 18 %, and the particles lose more"});
}

void claims(const Values& values, const Claims<Results>& claims) {
  claim_variants(claims, values);
  claim_design(claims, flap_design(values));
  const Theory linear = theory_of(flap_design(values));
  claims.at(by(&Results::wide))
      .check(
          "second-transient",
          fmt::format("The height of the second wave at the gauge agrees with the exact transient ({}).",
                      more_neighbours.name),
          "height from crest to trough during the second period [m]",
          [](const Results& r) { return r.heights(r.wide.back())[1]; },
          Bound{.limit = linear.steepness(at_gauge),
                .reason = "nonlinearity: k H/2 of this wave, a tenth for the published one",
                .expected = linear.heights[at_gauge][1],
                .relative = true});
  claim_loss(claims, linear, values);
  claim_scheme(claims, "", as_set, &Results::runs, linear);
  claim_scheme(claims, "-more", more_neighbours, &Results::wide, linear);
  claims.check(
      "transient-below",
      "The height of the second wave at the gauge in exact linear theory is more than 8 % below the settled height.",
      "lower than the settled height",
      [](const Results& r) { return r.linear.heights[at_gauge][1] < 0.92 * r.linear.settled_height; },
      Qualitative{.detector = "height of the second wave below 0.92 of the settled one",
                  .reason = "the front of the wave train disperses"});
}

void tabulate_heights(const Results& r, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "heights", "Heights from crest to trough at the gauge",
                "In the first and second period, and in the part of the third that was run [m]; the second one over "
                "the settled wave; the publication states a difference of 8 %.",
                {"", "period 1 [m]", "period 2 [m]", "2 to 2.75 [m]", "period 2, over settled"});
  const double settled = r.linear.settled_height;
  const auto row = [&](const std::string& label, const std::array<double, 3>& heights) {
    table.rows.push_back({label, heights[0], heights[1], heights[2], heights[1] / settled});
  };
  row("settled, linear", {settled, settled, settled});
  row("transient, linear", r.linear.heights[at_gauge]);
  for (const std::vector<FlapWaves>* runs : {&r.runs, &r.wide}) {
    for (const FlapWaves& one : *runs) row(fmt::format("SPH, {}, {} layers", one.scheme, one.layers), r.heights(one));
  }
}

void tabulate_loss(const Results& r, evidence::Exhibit& exhibit) {
  evidence::Table& table =
      add_table(exhibit, "loss", "Loss of wave height, and its remedies",
                "Rms elevation after one period, over the exact transient, at distances from the flap over the gauge "
                "distance; fraction lost between flap and gauge; escaped particles.",
                {"", "layers", "neighbours"});
  for (const double place : places) table.columns.emplace_back(fmt::format("{:g}", place), "");
  table.columns.emplace_back("lost", "");
  table.columns.emplace_back("out", "");
  for (const std::vector<FlapWaves>* runs : {&r.runs, &r.suspects, &r.wide}) {
    for (const FlapWaves& one : *runs) {
      table.rows.push_back({one.scheme, static_cast<double>(one.layers), one.neighbours});
      auto& row = table.rows.back();
      if (std::isfinite(one.breaks_down)) {
        row.resize(row.size() + places.size() + 1, "");
        row.emplace_back(fmt::format("breaks down at t = {:.3g} s", one.breaks_down));
        continue;
      }
      for (std::size_t k = 0; k < places.size(); ++k) row.emplace_back(r.share(one, k));
      row.emplace_back(r.loss(one));
      row.emplace_back(static_cast<double>(one.behind));
    }
  }
}

void draw(const Results& r, evidence::Exhibit& exhibit) {
  auto& panel = add_panel(exhibit, "gauge", "Elevation at x = L from the flap wavemaker",
                          "SPH, the exact transient from rest, and the settled wave, which has not arrived yet.",
                          {.x = "t/T", .y = "elevation [m]"}, {"sph-fig-5"});
  std::vector<double> phase = each(r.linear.time, [&](const double t) { return t / r.design.period; });
  panel.line("transient, linear theory", phase, r.linear.transient[at_gauge], Role::exact);
  panel.line("settled, linear theory", phase, r.linear.settled, Role::guide);
  for (const FlapWaves& one : r.runs) {
    panel.line(fmt::format("SPH as set, {} layers", one.layers), phase, one.elevation[at_gauge],
               &one == &r.runs.back() ? Role::computed : Role::peer);
  }
  panel.line(fmt::format("SPH, {}, {} layers", more_neighbours.name, r.wide.back().layers), phase,
             r.wide.back().elevation[at_gauge], Role::peer);

  auto& along = add_panel(exhibit, "loss", "Height of the waves along the flume",
                          "Rms elevation after one period, over the exact transient.",
                          {.x = "x/L", .y = "fraction of the height", .y_min = 0});
  const auto line = [&](const std::string& label, const FlapWaves& one, Role role) {
    along.line(label, places, each(indices(places.size()), [&](std::size_t k) { return r.share(one, k); }), role);
  };
  line("as set", r.runs.back(), Role::computed);
  line(more_neighbours.name, r.wide.back(), Role::guide);
  for (const FlapWaves& one : r.suspects) {
    if (!std::isfinite(one.breaks_down)) line(one.scheme, one, Role::peer);
  }
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  for (const auto& [id, runs] : {std::pair{"", &r.runs}, std::pair{"_more_neighbours", &r.wide}}) {
    const FlapWaves& finest = runs->back();
    const auto second = [&](const FlapWaves& one) { return r.heights(one)[1]; };
    exhibit.measure(fmt::format("second_wave_over_transient{}", id), second(finest) / r.linear.heights[at_gauge][1]);
    exhibit.measure(fmt::format("largest_mach_number{}", id), finest.extremes.mach);
    exhibit.measure(fmt::format("steps{}", id), static_cast<double>(finest.steps));
    measure_convergence(exhibit, fmt::format("second_wave{}", id), each(*runs, &FlapWaves::spacing),
                        each(*runs, second));
  }
  tabulate_heights(r, exhibit);
  tabulate_loss(r, exhibit);
  draw(r, exhibit);
}

void flap_wave_sph(Case& c) {
  c.title = "Regular wave of a flap: weakly compressible SPH";
  c.source = literature::plunging_sph +
             ", figure 5; E. H. Kennard, Quart. Appl. Math. 7 (1949) 303; R. G. Dean, R. A. Dalrymple, Water wave "
             "mechanics (1991), chapter 6";
  c.tiers = {Tier::quick, Tier::full, Tier::paper};
  c.parameters = with({real("depth", 4.0, "m", {1e-3, 1e3}, "still-water depth"),
                       real("period", 4.7, "s", {1e-3, 1e3}, "period of the flap"),
                       real("stroke", 2.11, "m", {1e-6, 1e3}, "stroke at the still-water level"),
                       real("gauge", 27.3, "m", {1e-3, 1e4}, "distance of the gauge from the flap at rest"),
                       real("flume", 2.25, "gauge", {1.1, 20}, "length of the flume"),
                       integer("layers", {10, 40, 80}, {4, 400}, "particle spacings in the depth")},
                      sph_parameters({.alpha = 0.01, .filter = 30}, "sqrt(g d)"));
  c.published = {{.tiles = {"sph-fig-5"},
                  .tier = Tier::full,
                  .stated = {"alpha", "depth", "period", "stroke", "gauge", "sound", "courant", "diffusion", "filter",
                             "isotropic", "kernel", "nu0", "shifting", "smagorinsky", "smoothing", "walls", "xsph"}}};
  c.study = Study(claims, compute, show, theory);
}

}  // namespace seiche::validation::cases::flap_wave_sph
