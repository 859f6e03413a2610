#include "validation/moving_pressure/pressure_regimes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 3.3";
constexpr double regular = 0.03;        // peaks of a periodic surface are equidistant to this fraction
constexpr double lowest_soliton = 0.1;  // what is lower may be a ripple

/// Without the first one, in which the start still shows.
std::vector<double> settled_distances(const PressureWaves& waves) {
  std::vector<double> result = distances(waves.source_peaks());
  if (!result.empty()) result.erase(result.begin());
  return result;
}

}  // namespace

std::vector<PressureRegime> main_pressure_regimes() {
  return {{"pressure", "pressure: solitons", {.pressure = 0.1, .half_width = 4}, 150},
          {"suction", "suction: solitons", {.pressure = -0.1, .half_width = 4}, 500, true, true},
          {"wide-suction", "wide suction: none", {.pressure = -0.1, .half_width = 6.5}, 800, false, true}};
}

std::vector<PressureRegime> more_pressure_regimes() {
  return {{"pressure-1", "narrow pressure", {.pressure = 0.1, .half_width = 1}, 150},
          {"pressure-2", "pressure, w = 2", {.pressure = 0.1, .half_width = 2}, 150},
          {"pressure-7", "wide pressure", {.pressure = 0.1, .half_width = 7}, 800, true, true},
          {"suction-7", "suction, w = 7", {.pressure = -0.1, .half_width = 7}, 500, false, true},
          {"weak-suction", "weak suction", {.pressure = -0.05, .half_width = 4}, 500},
          {"weak-wide-suction", "weak wide suction", {.pressure = -0.05, .half_width = 8}, 500, false}};
}

double solitons_ahead(const PressureWaves& waves) {
  const double count = waves.soliton_count(soliton_threshold);
  return count > 0 ? 1 : count;
}

bool usual_resolution(const PressureRun& run) {
  const PressureRun usual;
  return run.spacing == usual.spacing && run.tau == usual.tau;
}

std::optional<PressureRegime> pressure_regime_of(const PressureSource& source, const PressureRun& run) {
  if (!usual_resolution(run)) return std::nullopt;
  for (const auto& regimes : {main_pressure_regimes(), more_pressure_regimes()}) {
    const auto found = std::find_if(regimes.begin(), regimes.end(), [&](const PressureRegime& regime) {
      return regime.source == source && regime.time == run.time;
    });
    if (found != regimes.end()) return *found;
  }
  return std::nullopt;
}

void claim_leading_soliton(const Claims<PressureWaves>& claims, const std::string& id, const PressureSource& of,
                           const PressureRun& run) {
  claims.at(run.text())
      .from("Serre, La Houille Blanche 8 (1953) 374")
      .check(
          id,
          fmt::format("The speed of the leading soliton agrees with Serre's solitary wave of its height. ({})",
                      of.text()),
          "speed of its crest / (1 + height)^(1/2)",
          [](const PressureWaves& waves) {
            const PressureWaves::Leader leader = waves.leader(lowest_soliton);
            return leader.speed / std::sqrt(1 + leader.height);
          },
          Bound{.limit = run.spacing * run.spacing / 36 + std::exp(-8.0),
                .reason = "k^4 h^2/36, the error of the discrete model's dispersion law, at k = 1, the length of such "
                          "a wave; and exp(-8), what is still over the source of a wave four of its lengths ahead",
                .expected = 1});
}

void claim_pressure_regime(const Claims<PressureWaves>& all, const PressureRegime& regime, const PressureRun& run) {
  const Claims<PressureWaves> claims = all.at(run.text());
  const auto claim = [&](const std::string& id, const std::string& text, const std::string& quantity) {
    return evidence::Claim{.id = regime.id + "-" + id,
                           .text = fmt::format("{} ({})", text, regime.source.text()),
                           .quantity = quantity,
                           .source = source};
  };
  claims.check(
      regime.solitons ? claim("solitons", "Solitons run ahead of the source.", "forward solitons present")
                      : claim("none-ahead", "No soliton runs ahead of the source.", "forward solitons present"),
      solitons_ahead,
      Qualitative{
          .detector = fmt::format("a peak above {:g} beyond the front of the source at the end", soliton_threshold),
          .reason = "water escapes forward only as solitons; what is lower is the ripple of the start",
          .expected = regime.solitons});
  if (!regime.periodic) return;
  claims.check(
      claim("regular", "The surface at the source oscillates regularly.",
            "largest deviation of a distance of peaks from their mean, relative"),
      [](const PressureWaves& waves) { return relative_spread(settled_distances(waves)); },
      Bound{regular, "periodic, not chaotic; the first distance, in which the start still shows, is left out"});
}

void show_pressure_waves(evidence::Exhibit& exhibit, const std::string& prefix, const std::string& leader,
                         const PressureWaves& waves, double threshold) {
  const auto keep = [&](const std::string& name, double value) {
    if (std::isfinite(value)) exhibit.measure(name, value);
  };
  const PressureWaves::Extremes range = waves.range_at_source();
  const Period period = waves.period();
  keep(prefix + "forward_solitons", waves.soliton_count(threshold));
  keep(prefix + "maximum_ahead", waves.maximum_ahead());
  keep(prefix + "maximum_ahead_ever", waves.maximum_ahead_ever());
  keep(prefix + "lowest_at_source", range.lowest);
  keep(prefix + "highest_at_source", range.highest);
  keep(prefix + "period", period.length);
  keep(prefix + "autocorrelation", period.correlation);
  keep(prefix + "spread_of_peaks", relative_spread(settled_distances(waves)));
  keep(leader + "_speed", waves.leader(lowest_soliton).speed);
  keep(leader + "_height", waves.leader(lowest_soliton).height);
}

}  // namespace seiche::validation
