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

/// Where the numbers of regimes come from.
inline const std::string pressure_regression =
    "regression: an earlier program for the same equations, table reference_data/regression_moving_pressure";

/// A number of that table, of h = 0.25, tau = h/4, with half a unit of its last digit.
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
  std::optional<Printed> period = {};         ///< of the surface at the source
  std::optional<Printed> lowest = {};         ///< elevation at the source, second half of the run
  std::optional<Printed> highest = {};
};

/// The three regimes of the figure: solitons by pressure, solitons by suction, suction without solitons.
std::vector<PressureRegime> main_pressure_regimes(const Values& values);
/// Other widths and strengths.
std::vector<PressureRegime> more_pressure_regimes(const Values& values);
/// The numbers of regimes are of this spacing and step.
bool resolved_as_tabulated(const PressureRun& run);
/// The regime with exactly this source, time, spacing and step, if there is one.
std::optional<PressureRegime> pressure_regime_of(const Values& values, const PressureSource& source,
                                                 const PressureRun& run);

/// Elevation that counts as a forward soliton, unless a case says otherwise.
inline constexpr double soliton_threshold = 0.03;

/// The leading soliton, the first wave ahead that can be told from ripples, has the speed of a solitary wave. Of
/// sources from which one has got away by the end.
void claim_leading_soliton(const Claims<PressureWaves>& claims, const std::string& id, const PressureSource& source,
                           const PressureRun& run);
void claim_pressure_regime(const Claims<PressureWaves>& claims, const PressureRegime& regime, const PressureRun& run);

/// Measurements under names that begin with `prefix`, those of the leading soliton with `leader`.
void show_pressure_waves(evidence::Exhibit& exhibit, const std::string& prefix, const std::string& leader,
                         const PressureWaves& waves, double threshold);

}  // namespace seiche::validation
