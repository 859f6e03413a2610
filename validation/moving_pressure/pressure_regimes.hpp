/// What waves a travelling patch of pressure makes, regime by regime, and whether a computed history is of its regime.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/moving_pressure/pressure_source.hpp"

namespace seiche::validation {

/// Numbers of an independent implementation at h = 0.25, tau = h/4, with half a unit of their last digit.
struct Printed {
  double value = 0;
  double half_unit = 0;
};

struct PressureRegime {
  std::string id;
  std::string name;
  PressureSource source;
  double time = 0;
  int solitons = 0;                           ///< ahead of the source at the end
  std::optional<Printed> highest_ahead = {};  ///< the highest of them; without solitons, the highest ever ahead
  std::optional<Printed> leader = {};         ///< height of the first one
  std::optional<double> period = {};          ///< of the surface at the source
  std::optional<Printed> lowest = {};         ///< elevation at the source, second half of the run
  std::optional<Printed> highest = {};
};

/// The three regimes of the figure: solitons by pressure, solitons by suction, suction without solitons.
const std::vector<PressureRegime>& main_pressure_regimes();
/// Other widths and strengths.
const std::vector<PressureRegime>& more_pressure_regimes();
/// The regime with exactly this source, time, spacing and step, if there is one.
std::optional<PressureRegime> pressure_regime_of(const PressureSource& source, const PressureRun& run);

/// Elevation that counts as a forward soliton, unless a case says otherwise.
inline constexpr double soliton_threshold = 0.03;

/// Measures under names that begin with `prefix`.
void measure_pressure_waves(evidence::Record& record, const std::string& prefix, const PressureWaves& waves,
                            double threshold);
/// The leading soliton has the speed of a solitary wave: if it is high enough to be told from ripples, and has got away
/// from the source, by four of its lengths.
void claim_leading_soliton(evidence::Record& record, const std::string& id, const PressureWaves& waves,
                           double threshold);
void claim_pressure_regime(evidence::Record& record, const PressureRegime& regime, const PressureWaves& waves);

}  // namespace seiche::validation
