#include "validation/moving_pressure/pressure_regimes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

using evidence::Bound;
using evidence::Qualitative;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 3.3";
constexpr double regular = 0.03;        // peaks of a periodic surface are equidistant to this fraction
constexpr double lowest_soliton = 0.1;  // what is lower may be a ripple

/// Without the first one, in which the start still shows.
std::vector<double> settled_distances(const PressureWaves& waves) {
  std::vector<double> result = distances(waves.source_peaks());
  if (!result.empty()) result.erase(result.begin());
  return result;
}

/// The numbers of the table for a source.
PressureRegime with_numbers(PressureRegime regime, const io::Table& table) {
  bool counted = false;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto at = [&](const char* column) { return table.column(column)[k]; };
    if (at("p0") != regime.source.pressure || at("half_width") != regime.source.half_width) continue;
    regime.time = at("time");
    const Printed printed{at("value"), at("half_unit")};
    switch (std::lround(at("quantity"))) {
      case 1:
        regime.solitons = static_cast<int>(std::lround(printed.value));
        counted = true;
        break;
      case 2:
        regime.highest_ahead = printed;
        break;
      case 3:
        regime.leader = printed;
        break;
      case 4:
        regime.period = printed;
        break;
      case 5:
        regime.lowest = printed;
        break;
      default:
        regime.highest = printed;
    }
  }
  if (!counted) throw std::logic_error(fmt::format("no numbers are known of {}", regime.source.text()));
  return regime;
}

std::vector<PressureRegime> with_numbers(std::vector<PressureRegime> regimes, const Values& values) {
  const io::Table table = values.table("regression_moving_pressure");
  for (PressureRegime& regime : regimes) regime = with_numbers(regime, table);
  return regimes;
}

}  // namespace

std::vector<PressureRegime> main_pressure_regimes(const Values& values) {
  return with_numbers(
      {{.id = "pressure", .name = "pressure: solitons", .source = {.pressure = 0.1, .half_width = 4}},
       {.id = "suction", .name = "suction: solitons", .source = {.pressure = -0.1, .half_width = 4}},
       {.id = "wide-suction", .name = "wide suction: none", .source = {.pressure = -0.1, .half_width = 6.5}}},
      values);
}

std::vector<PressureRegime> more_pressure_regimes(const Values& values) {
  return with_numbers(
      {{.id = "pressure-1", .name = "narrow pressure", .source = {.pressure = 0.1, .half_width = 1}},
       {.id = "pressure-2", .name = "pressure, w = 2", .source = {.pressure = 0.1, .half_width = 2}},
       {.id = "pressure-7", .name = "wide pressure", .source = {.pressure = 0.1, .half_width = 7}},
       {.id = "suction-7", .name = "suction, w = 7", .source = {.pressure = -0.1, .half_width = 7}},
       {.id = "weak-suction", .name = "weak suction", .source = {.pressure = -0.05, .half_width = 4}},
       {.id = "weak-wide-suction", .name = "weak wide suction", .source = {.pressure = -0.05, .half_width = 8}}},
      values);
}

bool resolved_as_tabulated(const PressureRun& run) {
  const PressureRun tabulated;
  return run.spacing == tabulated.spacing && run.tau == tabulated.tau;
}

std::optional<PressureRegime> pressure_regime_of(const Values& values, const PressureSource& source,
                                                 const PressureRun& run) {
  if (!resolved_as_tabulated(run)) return std::nullopt;
  for (const auto& regimes : {main_pressure_regimes(values), more_pressure_regimes(values)}) {
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
      .check(
          {.id = id,
           .text =
               fmt::format("The leading soliton is as fast as Serre's solitary wave of its height. ({})", of.text()),
           .quantity = "speed of its crest / (1 + height)^(1/2)",
           .source = "Serre, La Houille Blanche 8 (1953) 374"},
          [](const PressureWaves& waves) {
            const PressureWaves::Leader leader = waves.leader(lowest_soliton);
            return leader.speed / std::sqrt(1 + leader.height);
          },
          Bound{.limit = run.spacing * run.spacing / 36 + std::exp(-8.0),
                .reason =
                    "k^4 h^2/36, the error of the discrete model's dispersion law, at k = 1, the length of such a "
                    "wave; and exp(-8), what is still over the source of a wave four of its lengths ahead",
                .expected = 1});
}

void claim_pressure_regime(const Claims<PressureWaves>& all, const PressureRegime& regime, const PressureRun& run) {
  Claims<PressureWaves> claims = all;
  using Measured = double (*)(const PressureWaves&);
  const auto check = [&](const std::string& id, const std::string& text, const std::string& quantity, Measured measured,
                         const evidence::Criterion& criterion, const std::string& from = pressure_regression) {
    claims.at(run.text())
        .check({.id = regime.id + "-" + id,
                .text = fmt::format("{} ({})", text, regime.source.text()),
                .quantity = quantity,
                .source = from},
               measured, criterion);
  };
  const auto number = [&](const std::string& id, const std::optional<Printed>& printed, const std::string& text,
                          const std::string& quantity, Measured measured) {
    if (!printed) return;
    const double h = run.spacing;
    check(id, fmt::format(fmt::runtime(text), printed->value), quantity, measured,
          Bound{.limit = printed->half_unit + h * h / 32,
                .reason = "half a unit of its last digit, and h^2/32: what straight lines between markers h/2 apart "
                          "miss of a crest of curvature 1",
                .expected = printed->value});
  };

  const std::string ahead = "highest elevation ahead";
  if (regime.solitons == 0) {
    check(
        "none-ahead", "No soliton runs ahead of the source.", "forward solitons present",
        [](const PressureWaves& waves) {
          const double count = waves.soliton_count(soliton_threshold);
          return count > 0 ? 1.0 : count;
        },
        Qualitative{
            .detector = fmt::format("a peak above {:g} beyond the front of the source at the end", soliton_threshold),
            .reason = "water escapes forward only as solitons; what is lower is the ripple of the start",
            .expected = false},
        source);
    number("highest-ahead", regime.highest_ahead, "Nothing ahead of the source is ever higher than {:g}.", ahead,
           [](const PressureWaves& waves) { return waves.maximum_ahead_ever(); });
  } else {
    check(
        "solitons", fmt::format("{} solitons have run ahead of the source.", regime.solitons), "peaks ahead",
        [](const PressureWaves& waves) { return waves.soliton_count(soliton_threshold); },
        Bound{.limit = 1,
              .reason = fmt::format("peaks above {:g}; one may just be leaving the source", soliton_threshold),
              .expected = static_cast<double>(regime.solitons)});
    number("highest-ahead", regime.highest_ahead, "The highest of them is {:g} high.", ahead,
           [](const PressureWaves& waves) { return waves.maximum_ahead(); });
  }
  number("leader-height", regime.leader, "The first of them is {:g} high.", "height of the leading soliton",
         [](const PressureWaves& waves) { return waves.leader(soliton_threshold).height; });
  number("lowest", regime.lowest, "The surface at the source falls to {:g}.",
         "lowest elevation at the source, second half of the run",
         [](const PressureWaves& waves) { return waves.range_at_source().lowest; });
  number("highest", regime.highest, "It rises to {:g}.", "highest elevation at the source, second half of the run",
         [](const PressureWaves& waves) { return waves.range_at_source().highest; });
  if (!regime.period) return;
  check(
      "period", fmt::format("The surface at the source oscillates with the period {:g}.", regime.period->value),
      "lag of the first peak of the autocorrelation", [](const PressureWaves& waves) { return waves.period().length; },
      Bound{.limit = regular,
            .reason = "the period drifts: neighbouring distances of peaks differ by as much",
            .expected = regime.period->value,
            .relative = true});
  claims = claims.only_if(regime.time >= 4 * regime.period->value,
                          "a run of less than four periods has no two distances of peaks beside the first");
  check(
      "regular", "It does so regularly.", "largest deviation of a distance of peaks from their mean, relative",
      [](const PressureWaves& waves) { return relative_spread(settled_distances(waves)); },
      Bound{regular, "periodic, not chaotic; the first distance, in which the start still shows, is left out"}, source);
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
