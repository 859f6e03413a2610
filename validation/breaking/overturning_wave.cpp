/*
A cosine of large amplitude, with the potential of the linear wave at its surface, steepens, overturns and plunges. Up
to jet impact the flow is irrotational, and a spectral boundary-integral computation gives the surface to many digits
(`seiche exact overturning_wave`): a plunging breaker without experimental scatter.

**What is compared.** The case computes the wave, checks conservation of volume, energy and impulse and the exact
initial kinetic energy, $\tfrac{\pi}{2} A^2 I_0(2A)$, and shows profiles until shortly before jet impact. It accepts
external results: the surface at given times, as points $(x, y)$ with their fraction $s$ of the arc length over one
wavelength, and the time of the first vertical front.

A surface is within the tolerance where every point agrees, in $x$ and $y$, within that fraction of the height of the
cosine.

**What to look at.** The tip of the jet. With too much physical or numerical viscosity the wave overturns late, with a
thick jet near the crest.
*/
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/overturning/overturning_wave.hpp"
#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/case/reference_case.hpp"
#include "validation/instruments/agreement.hpp"

namespace seiche::validation::cases::overturning_wave {

using exact::OverturningWave;

const std::string source = "Longuet-Higgins and Cokelet (1976); Baker, Meiron and Orszag (1982)";

OverturningWave wave_of(const Values& values) {
  const double depth = values.real("depth") > 0 ? values.real("depth") : std::numeric_limits<double>::infinity();
  const double wavenumber = 2 * std::numbers::pi / values.real("wavelength");
  const double period =
      2 * std::numbers::pi / exact::AiryDispersion(values.real("gravity"), depth).frequency(wavenumber);
  return OverturningWave({.amplitude = values.real("amplitude"),
                          .wavelength = values.real("wavelength"),
                          .depth = depth,
                          .gravity = values.real("gravity"),
                          .markers = values.count("markers"),
                          .last_time = values.real("periods") * period});
}

/// Instants at which surfaces are drawn and asked for: steepening, near the vertical front, and with a jet.
std::vector<double> instants_of(const OverturningWave& wave) {
  const double vertical = wave.vertical_tangent_time().value_or(wave.end_time());
  const double last = std::min(wave.well_resolved_until(), wave.end_time());
  return {0.5 * vertical, vertical, last};
}

struct Results {
  OverturningWave wave;
  exact::SelfTest identities;
  double uncertainty;
};

/// Steps are as long as their tolerance allows, and each may err by it: only the run knows how many there are.
void claim_self_test(const Claims<exact::SelfTest>& claims) {
  struct Declared {
    std::string name;
    double largest = 1e-7;
    std::string reason = "steps of tolerance 2e-11, whose errors add up; no more than 5000 of them";
  };
  const std::array identities{
      Declared{
          "kinetic energy at t = 0 is (pi/2) A^2 I_0(2A)", 1e-13,
          "integral equation solved to 1e-15, kernels rounded at neighbouring nodes 0.01 apart; sum over the nodes"},
      Declared{"volume is conserved"}, Declared{"energy is conserved"}, Declared{"horizontal impulse is conserved"}};
  for (std::size_t k = 0; k < identities.size(); ++k) {
    claims.check(
        fmt::format("identity-{}", k + 1),
        fmt::format("The residual of the reference solution's identity is within its accuracy: {}.",
                    identities[k].name),
        "relative defect",
        [k](const exact::SelfTest& test) -> Measurement {
          return {.value = test.at(k).defect, .told = {.limit = test.at(k).accuracy}};
        },
        Bound{.limit = Amount::told_by_run(identities[k].largest), .reason = identities[k].reason});
  }
}

void claims(const Values& /*values*/, const Claims<Results>& claims) {
  claim_self_test(claims.of(&Results::identities));
  claims.check(
      "overturns", "The free surface of the wave overturns.", "the front becomes vertical",
      [](const Results& r) { return r.wave.vertical_tangent_time().has_value(); },
      Qualitative{.detector = "x stops increasing along the surface",
                  .reason = "a cosine of this amplitude is far steeper than any steady wave",
                  .expected = true});
}

Results compute(const Run& run) {
  OverturningWave wave = wave_of(run);
  run.progress(0.6);
  return {.wave = wave, .identities = wave.self_test(), .uncertainty = wave.uncertainty()};
}

void show(const Results& r, const Values& /*values*/, evidence::Exhibit& exhibit) {
  exhibit.measure("reference_uncertainty", r.uncertainty);
  exhibit.measure("vertical_tangent_time", r.wave.vertical_tangent_time().value_or(nan));
  exhibit.measure("touch_down_time", r.wave.touch_down_time().value_or(nan));
  exhibit.measure("end_time", r.wave.end_time());
  auto& figure = exhibit.figure("profiles", "From a cosine to a plunging jet",
                                "Surfaces over one wavelength, to the same scale both ways.");
  const auto draw = [&](evidence::Figure& to, double t, const std::string& title) {
    const auto profile = r.wave.profile(t, 401);
    to.panel({.x = "x [m]", .y = "y [m]", .title = title, .equal_aspect = true})
        .line("surface", profile.x, profile.y, Role::exact);
  };
  for (const double t : instants_of(r.wave)) draw(figure, t, fmt::format("t = {:.4g} s", t));
  auto& film =
      exhibit.figure("film", "Overturning of the wave", "Surfaces over one wavelength, from the start to the jet.");
  film.drawing = "film";
  for (const double t : evenly(0, instants_of(r.wave).back(), 25)) draw(film, t, fmt::format("t = {:.2f} s", t));
}

std::vector<WantedTable> wanted(const Values& values) {
  const Lazy<OverturningWave> wave([values] { return wave_of(values); });
  constexpr std::size_t points = 2001;
  // Surfaces at equal arc length, joined by straight lines.
  const Lazy<std::map<double, OverturningWave::Profile>> surfaces([wave] {
    std::map<double, OverturningWave::Profile> profiles;
    for (const double t : instants_of(*wave)) profiles.emplace(t, wave->profile(t, points));
    return profiles;
  });
  const std::vector<double> fractions = evenly(0, 1, points);
  const auto along = [surfaces, fractions](std::vector<double> OverturningWave::Profile::*coordinate) {
    return [surfaces, fractions, coordinate](Place p) {
      return linear_at({fractions, surfaces->at(p.group).*coordinate}, p.abscissa);
    };
  };
  const std::function<double()> vertical = [wave] { return wave->vertical_tangent_time().value_or(nan); };
  const std::vector<Requirement> close{
      {.measure = Measure::largest_error,
       .criterion = Bound{.limit = values.real("tolerance") * values.real("amplitude"),
                          .reason = "the case's parameter `tolerance`, of the amplitude; by default 3.5 %, less than "
                                    "the growth of the jet between the instants of the template"},
       .text = "The surface agrees with potential flow within the tolerance, by default 3.5 % of the amplitude.",
       .source = source}};
  return {
      {.name = "surface",
       .kind = WantedTable::Kind::profile,
       .group = Column{"t", "s", "time"},
       .abscissa = Column{"s", "1", "arc length from the point that starts at the crest, over the whole"},
       .quantities = {{.column = {"x", "m", "position"},
                       .reference = along(&OverturningWave::Profile::x),
                       .requirements = close},
                      {.column = {"y", "m", "elevation"},
                       .reference = along(&OverturningWave::Profile::y),
                       .requirements = close}},
       .groups = [wave] { return instants_of(*wave); },
       .points = [](double) { return evenly(0, 1, 201); }},
      {.name = "numbers",
       .quantities = {wanted_number(
           {"vertical_time", "s", "when the front is first vertical"}, vertical, values,
           "The time at which the front is vertical agrees with potential flow within the tolerance, by default 3.5 %.",
           source)}}};
}

void overturning_wave(Case& c) {
  c.title = "Overturning and plunging of a wave";
  c.source = "M. S. Longuet-Higgins, E. D. Cokelet, Proc. R. Soc. A 350 (1976) 1; " + literature::baker_meiron_orszag;
  c.tiers = {Tier::quick};
  c.parameters = {
      real("amplitude", 0.5, "m", {1e-9, 1e6}, "half the height of the cosine"),
      real("wavelength", 2 * std::numbers::pi, "m", {1e-9, 1e6}, "wavelength"),
      real("depth", 0.0, "m", {0, 1e6}, "depth; 0 is infinitely deep water"),
      real("gravity", 1.0, "m/s^2", {1e-6, 1e6}, "acceleration of gravity"),
      real("periods", 0.7, "1", {1e-3, 1}, "computed periods of the linear wave"),
      integer("markers", {384, 512, 1024}, {64, 4096}, "nodes per wavelength, even"),
      tolerance_parameter(),
  };
  c.study = Study(claims, compute, show, source);
  c.submission = {.tables = wanted};
}

}  // namespace seiche::validation::cases::overturning_wave
