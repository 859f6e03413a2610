/// What waves a travelling patch of pressure makes, regime by regime, and whether a computed history is of its regime.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/evidence/record.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/parameter.hpp"
#include "validation/moving_pressure/pressure_source.hpp"

namespace seiche::validation {

struct PressureRegime {
  std::string id;
  std::string name;
  PressureSource source;
  double time = 0;
  bool solitons = true;   ///< run ahead of the source
  bool periodic = false;  ///< the surface at the source, for four periods or more
};

/// The three regimes of the figure: solitons by pressure, solitons by suction, suction without solitons.
std::vector<PressureRegime> main_pressure_regimes();
/// Other widths and strengths.
std::vector<PressureRegime> more_pressure_regimes();
/// Regimes are known at this spacing and step: at others the wide suction is near the end of its own.
bool usual_resolution(const PressureRun& run);
/// The regime with exactly this source, time, spacing and step, if there is one.
std::optional<PressureRegime> pressure_regime_of(const PressureSource& source, const PressureRun& run);

/// Elevation that counts as a forward soliton, unless a case says otherwise.
inline constexpr double soliton_threshold = 0.03;

/// 1 if solitons are ahead of the source at the end, 0 if not.
double solitons_ahead(const PressureWaves& waves);

/// The leading soliton, the first wave ahead that can be told from ripples, has the speed of a solitary wave. Of
/// sources from which one has got away by the end.
void claim_leading_soliton(const Claims<PressureWaves>& claims, const std::string& id, const PressureSource& source,
                           const PressureRun& run);
void claim_pressure_regime(const Claims<PressureWaves>& claims, const PressureRegime& regime, const PressureRun& run);

/// Measurements under names that begin with `prefix`, those of the leading soliton with `leader`.
void show_pressure_waves(evidence::Exhibit& exhibit, const std::string& prefix, const std::string& leader,
                         const PressureWaves& waves, double threshold);

}  // namespace seiche::validation
