#include "validation/moving_pressure/pressure_regimes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {
namespace {

using evidence::Bound;
using evidence::Qualitative;

const std::string source = "Frank, Discrete models of incompressible fluid (1994), section 3.3";
const std::string digits = source + "; number computed once by an independent implementation";
constexpr double regular = 0.03;  // peaks of a periodic surface are equidistant to this fraction

/// Without the first one, in which the start still shows.
std::vector<double> settled_distances(const PressureWaves& waves) {
  std::vector<double> result = distances(waves.source_peaks());
  if (!result.empty()) result.erase(result.begin());
  return result;
}

class RegimeClaims {
 public:
  RegimeClaims(evidence::Record& record, const PressureRegime& regime, const PressureWaves& waves)
      : record_(record), regime_(regime), waves_(waves) {}

  void solitons() {
    const auto count = static_cast<double>(waves_.forward_solitons(soliton_threshold).size());
    if (regime_.solitons == 0) {
      check("none-ahead", "No soliton runs ahead of the source.", "forward solitons present", count > 0 ? 1 : 0,
            Qualitative{.detector = fmt::format("a peak above {:g} beyond the front of the source at the end",
                                                soliton_threshold),
                        .reason = "water escapes forward only as solitons; what is lower is the ripple of the start",
                        .expected = false});
      return;
    }
    check("solitons", fmt::format("{} solitons have run ahead of the source.", regime_.solitons), "peaks ahead", count,
          Bound{.limit = 1,
                .reason = fmt::format("peaks above {:g}; one may just be leaving the source", soliton_threshold),
                .expected = static_cast<double>(regime_.solitons)});
  }

  void heights() {
    const bool any = regime_.solitons > 0;
    number("highest-ahead", regime_.highest_ahead, any ? waves_.maximum_ahead() : waves_.maximum_ahead_ever(),
           any ? "The highest of them is {:g} high." : "Nothing ahead of the source is ever higher than {:g}.",
           "highest elevation ahead");
    number("leader-height", regime_.leader, waves_.leader(soliton_threshold).height, "The first of them is {:g} high.",
           "height of the leading soliton");
    const PressureWaves::Extremes range = waves_.range_at_source();
    number("lowest", regime_.lowest, range.lowest, "The surface at the source falls to {:g}.",
           "lowest elevation at the source, second half of the run");
    number("highest", regime_.highest, range.highest, "It rises to {:g}.",
           "highest elevation at the source, second half of the run");
  }

  void oscillation() {
    if (!regime_.period) return;
    check("period", fmt::format("The surface at the source oscillates with the period {:g}.", *regime_.period),
          "lag of the first peak of the autocorrelation", waves_.period().length,
          Bound{.limit = regular,
                .reason = "the period drifts: neighbouring distances of peaks differ by as much",
                .expected = *regime_.period,
                .relative = true},
          digits);
    const std::vector<double> between = settled_distances(waves_);
    if (between.size() < 2) return;
    check("regular", "It does so regularly.", "largest deviation of a distance of peaks from their mean, relative",
          relative_spread(between),
          Bound{regular, "periodic, not chaotic; the first distance, in which the start still shows, is left out"});
  }

 private:
  void check(const std::string& id, const std::string& text, const std::string& quantity, double value,
             const evidence::Criterion& criterion, const std::string& where = source) {
    record_.check({.id = regime_.id + "-" + id,
                   .text = fmt::format("{} ({})", text, waves_.source().text()),
                   .quantity = quantity,
                   .source = where},
                  {.value = value, .resolution = waves_.run().text()}, criterion);
  }

  void number(const std::string& id, const std::optional<Printed>& printed, double value, const std::string& text,
              const std::string& quantity) {
    if (!printed) return;
    const double h = waves_.run().spacing;
    check(id, fmt::format(fmt::runtime(text), printed->value), quantity, value,
          Bound{.limit = printed->half_unit + h * h / 32,
                .reason = "half a unit of its last digit, and h^2/32: what straight lines between markers h/2 apart "
                          "miss of a crest of curvature 1",
                .expected = printed->value},
          digits);
  }

  evidence::Record& record_;
  const PressureRegime& regime_;
  const PressureWaves& waves_;
};

}  // namespace

const std::vector<PressureRegime>& main_pressure_regimes() {
  static const std::vector<PressureRegime> regimes = {
      {.id = "pressure",
       .name = "pressure: solitons",
       .source = {.pressure = 0.1, .half_width = 4},
       .time = 150,
       .solitons = 4,
       .highest_ahead = Printed{0.56, 0.005}},
      {.id = "suction",
       .name = "suction: solitons",
       .source = {.pressure = -0.1, .half_width = 4},
       .time = 500,
       .solitons = 7,
       .leader = Printed{0.34, 0.005},
       .period = 67.5,
       .lowest = Printed{-0.14, 0.005},
       .highest = Printed{1.03, 0.005}},
      {.id = "wide-suction",
       .name = "wide suction: none",
       .source = {.pressure = -0.1, .half_width = 6.5},
       .time = 800,
       .solitons = 0,
       .highest_ahead = Printed{0.087, 0.0005},
       .period = 91.3,
       .lowest = Printed{-0.055, 0.0005},
       .highest = Printed{0.92, 0.005}},
  };
  return regimes;
}

const std::vector<PressureRegime>& more_pressure_regimes() {
  static const std::vector<PressureRegime> regimes = {
      {.id = "pressure-1",
       .name = "narrow pressure",
       .source = {.pressure = 0.1, .half_width = 1},
       .time = 150,
       .solitons = 3,
       .highest_ahead = Printed{0.40, 0.005}},
      {.id = "pressure-2",
       .name = "pressure, w = 2",
       .source = {.pressure = 0.1, .half_width = 2},
       .time = 150,
       .solitons = 4,
       .highest_ahead = Printed{0.53, 0.005}},
      {.id = "pressure-7",
       .name = "wide pressure",
       .source = {.pressure = 0.1, .half_width = 7},
       .time = 800,
       .solitons = 20,
       .highest_ahead = Printed{0.55, 0.005},
       .period = 38.8},
      {.id = "suction-7",
       .name = "suction, w = 7",
       .source = {.pressure = -0.1, .half_width = 7},
       .time = 500,
       .solitons = 0,
       .period = 98},
      {.id = "weak-suction",
       .name = "weak suction",
       .source = {.pressure = -0.05, .half_width = 4},
       .time = 500,
       .solitons = 5},
      {.id = "weak-wide-suction",
       .name = "weak wide suction",
       .source = {.pressure = -0.05, .half_width = 8},
       .time = 500,
       .solitons = 0,
       .highest_ahead = Printed{0.049, 0.0005},
       .period = 157},
  };
  return regimes;
}

std::optional<PressureRegime> pressure_regime_of(const PressureSource& source, const PressureRun& run) {
  const PressureRun printed;
  if (run.spacing != printed.spacing || run.tau != printed.tau) return std::nullopt;
  for (const auto* regimes : {&main_pressure_regimes(), &more_pressure_regimes()}) {
    const auto found = std::find_if(regimes->begin(), regimes->end(), [&](const PressureRegime& regime) {
      return regime.source == source && regime.time == run.time;
    });
    if (found != regimes->end()) return *found;
  }
  return std::nullopt;
}

void measure_pressure_waves(evidence::Record& record, const std::string& prefix, const PressureWaves& waves,
                            double threshold) {
  const auto keep = [&](const std::string& name, double value) {
    if (std::isfinite(value)) record.measure(prefix + name, value);
  };
  const PressureWaves::Extremes range = waves.range_at_source();
  const Period period = waves.period();
  keep("forward_solitons", static_cast<double>(waves.forward_solitons(threshold).size()));
  keep("maximum_ahead", waves.maximum_ahead());
  keep("maximum_ahead_ever", waves.maximum_ahead_ever());
  keep("lowest_at_source", range.lowest);
  keep("highest_at_source", range.highest);
  keep("period", period.length);
  keep("autocorrelation", period.correlation);
  keep("spread_of_peaks", relative_spread(settled_distances(waves)));
}

void claim_leading_soliton(evidence::Record& record, const std::string& id, const PressureWaves& waves,
                           double threshold) {
  const PressureWaves::Leader leader = waves.leader(threshold);
  constexpr double lowest_soliton = 0.1;
  if (!(leader.height >= lowest_soliton)) return;
  const double wavenumber = std::sqrt(0.75 * leader.height / (1 + leader.height));  // of sech^2
  if (leader.place - waves.source().half_width < 4 / wavenumber) return;
  const double h = waves.run().spacing;
  record.measure(id + "_speed", leader.speed);
  record.measure(id + "_height", leader.height);
  record.check({.id = id,
                .text = fmt::format("The leading soliton is as fast as Serre's solitary wave of its height. ({})",
                                    waves.source().text()),
                .quantity = "speed of its crest / (1 + height)^(1/2)",
                .source = "Serre, La Houille Blanche 8 (1953) 374"},
               {.value = leader.speed / std::sqrt(1 + leader.height), .resolution = waves.run().text()},
               Bound{.limit = h * h / 36,
                     .reason = "k^4 h^2/36, the error of the discrete model's dispersion law, at k = 1, the length of "
                               "such a wave",
                     .expected = 1});
}

void claim_pressure_regime(evidence::Record& record, const PressureRegime& regime, const PressureWaves& waves) {
  RegimeClaims claims(record, regime, waves);
  claims.solitons();
  claims.heights();
  claims.oscillation();
}

}  // namespace seiche::validation
