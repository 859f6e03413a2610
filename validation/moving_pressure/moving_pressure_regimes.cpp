/*
A pressure source at the critical speed need not send solitons ahead. Frank (1994) found a regime of wide *suction* in
which the surface under the source rises and falls periodically and no soliton leaves ahead.

**Set-up.** As in `moving_pressure_1d`: $p = p_0 \cos^2(\pi z/2w)$, speed 1, still water of depth 1. Three sources:
pressure $p_0 = 0.1$, $w = 4$; suction $p_0 = -0.1$ of the same width; suction of the half-width $w = 6.5$.

**What is compared.** Whether solitons are ahead of the source at the end, and the regularity of the peaks of the
surface at the source. The leading solitons have the speed of Serre's solitary wave. In the tier `full`, six more
sources, and the wide suction again with half the spacing and half the step.

**What to look at.** The third ridge plot: an elevation grows under the source, runs ahead of it by a few depths, is
overtaken and decays: a soliton that does not escape. At $w = 4$ every such elevation escapes; beyond $w = 7$ some do.
*/
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/case/literature.hpp"
#include "validation/moving_pressure/pressure_regimes.hpp"

namespace seiche::validation::cases::moving_pressure_regimes {

struct Computed {
  PressureRegime regime;
  PressureWaves waves;
};

struct Results {
  std::vector<Computed> regimes;
  std::optional<PressureWaves> fine;  ///< the last of the main ones with half the spacing and half the step
};

constexpr std::size_t wide_suction = 2;  // of the regimes

PressureRun run_of(const Values& values, double time, double fineness = 1) {
  const double h = values.real("h") / fineness;
  return {.time = time, .spacing = h, .tau = values.real("tau_over_h") * h};
}

void claims(const Values& values, const Claims<Results>& claims) {
  const std::vector<PressureRegime> regimes = pressure_regimes(values.tier() != Tier::quick);
  for (std::size_t k = 0; k < regimes.size(); ++k) {
    const PressureRegime& regime = regimes[k];
    const PressureRun run = run_of(values, regime.time);
    const auto of = claims.of([k](const Results& r) -> const PressureWaves& { return r.regimes.at(k).waves; });
    if (regime.solitons) claim_leading_soliton(of, regime.id + "-leader", regime.source, run);
    claim_pressure_regime(
        of.only_if(usual_resolution(run), "at another resolution the wide suction may be near the limit of its regime"),
        regime, run);
  }
  const auto fine = claims.only_if(values.tier() != Tier::quick, "half the spacing is computed in the tier full")
                        .at(run_of(values, regimes[wide_suction].time, 2).text());
  // The regime is the model's, not the resolution's.
  fine.check(
      "resolved", "The period under the wide suction changes by less than 1 % with half the spacing and half the step.",
      "period / period at twice the spacing",
      [](const Results& r) { return r.fine.value().period().length / r.regimes[wide_suction].waves.period().length; },
      Bound{.limit = 0.01,
            .reason = "the celerity error of waves of wavenumber 1 is h^2/36 and tau^2/24, together 2e-3; the period "
                      "depends on celerities relative to the source, which are several times smaller",
            .expected = 1});
  fine.check(
      "resolved-none-ahead", "The number of solitons ahead of the pressure is zero.", "forward solitons present",
      [](const Results& r) { return solitons_ahead(r.fine.value()); },
      Qualitative{.detector = "a peak above 0.03 beyond the front of the source at the end",
                  .reason = "as above",
                  .expected = false});
}

Results compute(const Run& run) {
  const std::vector<PressureRegime> regimes = pressure_regimes(run.tier() != Tier::quick);
  // A part of the work is as the square of the time: a longer run has a longer channel too.
  double whole = 0;
  for (const PressureRegime& regime : regimes) whole += regime.time * regime.time;
  double done = 0;
  Results results;
  for (const PressureRegime& regime : regimes) {
    const double part = regime.time * regime.time / whole;
    results.regimes.push_back({regime, PressureWaves(regime.source, run_of(run, regime.time),
                                                     [&](double fraction) { run.progress(done + part * fraction); })});
    done += part;
  }
  if (run.tier() != Tier::quick) {
    const PressureRegime& wide = regimes[wide_suction];
    results.fine.emplace(wide.source, run_of(run, wide.time, 2), [](double) {});
  }
  return results;
}

void draw(evidence::Exhibit& exhibit, const std::vector<Computed>& computed) {
  auto& ridges =
      exhibit.figure("frank_pressure", "Three sources at the critical speed",
                     "Surfaces one above the other, time upwards, in the frame of the source. Pressure and suction "
                     "send solitons ahead; under wide suction the surface rises and falls periodically.",
                     {"frank-pressure"});
  auto& history = exhibit.figure("at_source", "The surface at the source",
                                 "Under pressure the surface oscillates slightly, once per soliton; under suction a "
                                 "wave of the height of the depth grows, and escapes ahead or decays.");
  for (std::size_t k = 0; k <= wide_suction; ++k) {
    computed[k].waves.draw_ridges(ridges);
    computed[k].waves.draw_at_source(history);
  }
  computed[wide_suction].waves.draw_at_source(ridges);
}

void show(const Results& results, const Values& /*values*/, evidence::Exhibit& exhibit) {
  evidence::Table& table = add_table(exhibit, "regimes", "Sources at the critical speed",
                                     "Solitons ahead at the end and period at the source.",
                                     {"regime", "p0 [rho g H]", "w [H]", "time [(H/g)^(1/2)]", "solitons [1]",
                                      "highest ahead, ever [H]", "period [(H/g)^(1/2)]"});
  for (const auto& [regime, waves] : results.regimes) {
    show_pressure_waves(exhibit, regime.id + "_", regime.id + "-leader", waves, soliton_threshold);
    table.rows.push_back({regime.name, regime.source.pressure, regime.source.half_width, regime.time,
                          waves.soliton_count(soliton_threshold), waves.maximum_ahead_ever(), waves.period().length});
  }
  draw(exhibit, results.regimes);
  if (results.fine) {
    show_pressure_waves(exhibit, "wide-suction_fine_", "wide-suction_fine-leader", *results.fine, soliton_threshold);
  }
}

void moving_pressure_regimes(Case& c) {
  c.title = "Pressure and suction at the critical speed: solitons ahead or periodic surface";
  c.source = literature::frank + ", section 3.3; T. Y. Wu, J. Fluid Mech. 184 (1987) 75";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("h", 0.25, "H", {0.05, 0.5}, "node spacing at rest"),
      real("tau_over_h", 0.25, "(g H)^(-1/2)", {0.01, 0.7}, "time step over the node spacing"),
  };
  c.published = {{.tiles = {"frank-pressure"}}};
  c.study = Study(claims, compute, show, "the scheme is second-order accurate");
}

}  // namespace seiche::validation::cases::moving_pressure_regimes
