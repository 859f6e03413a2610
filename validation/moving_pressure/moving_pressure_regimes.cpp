/*
A pressure source at the critical speed need not send solitons ahead. Frank (1994) found that a *suction* of some width
lives in a regime of its own: the surface under it rises and falls periodically, for ever, and nothing leaves forward.

**Set-up.** As in `moving_pressure_1d`: $p = p_0 \cos^2(\pi z/2w)$, speed 1, still water of depth 1. Three sources:
pressure $p_0 = 0.1$, $w = 4$; suction $p_0 = -0.1$ of the same width; suction of the half-width $w = 6.5$.

**What is compared.** The number of solitons ahead; the highest elevation ahead at any time; the period of the surface
at the source, from its autocorrelation, and how regular its peaks are; all with an independent implementation. The
leading solitons have the speed of Serre's solitary wave. In the tier `full`, six more sources, and the wide suction
again with half the spacing and half the step.

**What to look at.** The third ridge plot: a hump grows under the source, runs ahead of it by a few depths, is caught
and falls back. It is a soliton that does not get away. At $w = 4$ every such hump escapes; beyond $w = 7$ now and then
one does.
*/
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "validation/case/case.hpp"
#include "validation/moving_pressure/pressure_regimes.hpp"

namespace seiche::validation::cases {
namespace {

using evidence::Bound;

struct Computed {
  PressureRegime regime;
  PressureWaves waves;
};

PressureRun run_of(const Run& run, double time) {
  return {.time = time, .spacing = run.real("h"), .tau = run.real("tau_over_h") * run.real("h")};
}

/// Progress of a part of the work, which is as the square of the time: a longer run has a longer channel too.
class Share {
 public:
  Share(const Run& run, double all) : run_(run), all_(all) {}
  PressureWaves compute(const PressureRegime& regime) {
    const double part = regime.time * regime.time / all_;
    PressureWaves waves(regime.source, run_of(run_, regime.time),
                        [&](double fraction) { run_.progress(done_ + part * fraction); });
    done_ += part;
    return waves;
  }

 private:
  const Run& run_;
  double all_;
  double done_ = 0;
};

std::vector<Computed> compute(Running& run) {
  std::vector<PressureRegime> regimes = main_pressure_regimes();
  if (run.tier() != Tier::quick) {
    regimes.insert(regimes.end(), more_pressure_regimes().begin(), more_pressure_regimes().end());
  }
  double all = 0;
  for (const PressureRegime& regime : regimes) all += regime.time * regime.time;
  Share share(run, all);
  std::vector<Computed> computed;
  for (const PressureRegime& regime : regimes) computed.push_back({regime, share.compute(regime)});
  return computed;
}

evidence::Table table_of(const std::vector<Computed>& computed) {
  evidence::Table table{
      .id = "regimes",
      .title = "Sources at the critical speed",
      .caption = "Solitons ahead at the end and period at the source; in brackets, of an independent implementation.",
      .columns = {{"regime", ""},
                  {"p0", "rho g H"},
                  {"w", "H"},
                  {"time", "(H/g)^(1/2)"},
                  {"solitons", "1"},
                  {"(solitons)", "1"},
                  {"highest ahead, ever", "H"},
                  {"period", "(H/g)^(1/2)"},
                  {"(period)", "(H/g)^(1/2)"}}};
  for (const Computed& one : computed) {
    const PressureRegime& regime = one.regime;
    const PressureWaves& waves = one.waves;
    const auto count = static_cast<double>(waves.forward_solitons(soliton_threshold).size());
    const auto period = [&](double value) {
      return regime.period ? std::variant<double, std::string>(value) : std::string("steady");
    };
    table.rows.push_back({regime.name, regime.source.pressure, regime.source.half_width, regime.time, count,
                          static_cast<double>(regime.solitons), waves.maximum_ahead_ever(),
                          period(waves.period().length), period(regime.period.value_or(0))});
  }
  return table;
}

/// When the surface over the wide suction is highest, beside an independent implementation.
evidence::Table peaks_table(const PressureWaves& waves) {
  evidence::Table table{.id = "peaks",
                        .title = "Wide suction: the surface at the source is highest",
                        .caption = "In brackets, by an independent implementation.",
                        .columns = {{"peak", ""}, {"t", "(H/g)^(1/2)"}, {"(t)", "(H/g)^(1/2)"}, {"elevation", "H"}}};
  const std::vector<double> expected = {56.2, 152.5, 246.2, 338.8, 430, 520, 611, 702, 791};
  const std::vector<Crest> peaks = waves.source_peaks();
  for (std::size_t k = 0; k < std::min(peaks.size(), expected.size()); ++k) {
    table.rows.push_back({static_cast<double>(k + 1), peaks[k].place, expected[k], peaks[k].height});
  }
  return table;
}

void draw(evidence::Record& record, const std::vector<Computed>& computed) {
  auto& ridges = record.figure("frank_pressure", "Three sources at the critical speed",
                               "Surfaces one above the other, time upwards, in the frame of the source. Pressure and "
                               "suction send solitons ahead; wide suction lifts the surface, time and again, and lets "
                               "it fall.",
                               {"frank-pressure"});
  auto& history = record.figure("at_source", "The surface at the source",
                                "Under pressure it hardly moves, once up and down for every soliton; under suction a "
                                "wave as high as the water is deep grows and leaves, forward or not at all.");
  const std::size_t shown = main_pressure_regimes().size();
  for (std::size_t k = 0; k < shown; ++k) {
    computed[k].waves.draw_ridges(ridges);
    computed[k].waves.draw_at_source(history);
  }
  computed[shown - 1].waves.draw_at_source(ridges);
}

/// The regime is the model's, not the resolution's.
void claim_resolved(Running& run, const Computed& coarse) {
  const PressureRun fine_run{.time = coarse.waves.run().time,
                             .spacing = 0.5 * coarse.waves.run().spacing,
                             .tau = 0.5 * coarse.waves.run().tau};
  const PressureWaves fine(coarse.regime.source, fine_run, [](double) {});
  measure_pressure_waves(run.record, "wide-suction_fine_", fine, soliton_threshold);
  run.record.check(
      {.id = "resolved",
       .text = "Half the spacing and half the step change its period by less than a hundredth.",
       .quantity = "period / period at twice the spacing",
       .source = "the scheme is of second order"},
      {.value = fine.period().length / coarse.waves.period().length, .resolution = fine_run.text()},
      Bound{.limit = 0.01,
            .reason = "waves of wavenumber 1 travel wrong by h^2/36 and tau^2/24, together 2e-3; the period depends on "
                      "speeds less the source's, which are several times smaller than speeds",
            .expected = 1});
  run.record.check(
      {.id = "resolved-none-ahead",
       .text = "And still no soliton runs ahead.",
       .quantity = "forward solitons present",
       .source = "the scheme is of second order"},
      {.value = fine.forward_solitons(soliton_threshold).empty() ? 0.0 : 1.0, .resolution = fine_run.text()},
      evidence::Qualitative{.detector = "a peak above 0.03 beyond the front of the source at the end",
                            .reason = "as above",
                            .expected = false});
}

void run(Running& run) {
  const std::vector<Computed> computed = compute(run);
  for (const auto& [regime, waves] : computed) {
    measure_pressure_waves(run.record, regime.id + "_", waves, soliton_threshold);
    claim_leading_soliton(run.record, regime.id + "-leader", waves, soliton_threshold);
    // At another resolution the numbers are others, and the wide suction is near the end of its regime.
    if (pressure_regime_of(waves.source(), waves.run())) claim_pressure_regime(run.record, regime, waves);
  }
  run.record.table(table_of(computed));
  run.record.table(peaks_table(computed[main_pressure_regimes().size() - 1].waves));
  draw(run.record, computed);
  if (run.tier() != Tier::quick) claim_resolved(run, computed[main_pressure_regimes().size() - 1]);
}

}  // namespace

Case moving_pressure_regimes() {
  Case c;
  c.title = "Pressure and suction at the critical speed: solitons ahead, or none";
  c.source =
      "A. M. Frank, Discrete models of incompressible fluid, doctoral thesis (1994), section 3.3; T. Y. Wu, J. Fluid "
      "Mech. 184 (1987) 75";
  c.tiers = {Tier::quick, Tier::full};
  c.parameters = {
      real("h", 0.25, "H", {0.05, 0.5}, "distance of markers at rest"),
      real("tau_over_h", 0.25, "(g H)^(-1/2)", {0.01, 0.7}, "time step over the distance of markers"),
  };
  c.run = run;
  return c;
}

}  // namespace seiche::validation::cases
