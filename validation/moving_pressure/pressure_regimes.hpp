/// What waves a travelling patch of pressure makes, regime by regime, and whether a computed history is of its regime.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/evidence/figure.hpp"
#include "reports/evidence/record.hpp"
#include "seiche/samples.hpp"
#include "validation/case/claims.hpp"
#include "validation/case/parameter.hpp"
#include "validation/instruments/oscillation.hpp"

namespace seiche::validation {

/// p = pressure cos^2(pi z/(2 half_width)) for |z| < half_width, z = x - speed t; grows from nothing during `ramp`.
struct PressureSource {
  double pressure = 0.1;  ///< at the centre; negative for suction
  double half_width = 4;
  double speed = 1;
  double ramp = 5;

  bool operator==(const PressureSource&) const = default;
  [[nodiscard]] double at(double x, double time) const;
  /// "p = -0.1, w = 6.5".
  [[nodiscard]] std::string text() const { return fmt::format("p = {:g}, w = {:g}", pressure, half_width); }
};

struct PressureRun {
  double time = 150;
  double spacing = 0.25;
  double tau = 0.0625;

  /// "h = 0.25, tau = 0.0625, t = 150".
  [[nodiscard]] std::string text() const { return fmt::format("h = {:g}, tau = {:g}, t = {:g}", spacing, tau, time); }
};

/// Elevations along the channel; places are counted from the centre of the source.
struct PressureSurface {
  double time = 0;
  std::vector<double> place = {}, elevation = {};
};

class PressureWaves {
 public:
  /// Computes the whole history. The channel begins 250 depths behind the start of the source, between walls, and is
  /// long enough for the fastest solitons. Throws seiche::Divergence.
  PressureWaves(PressureSource source, PressureRun run, const std::function<void(double)>& progress);

  /// Of the elevation at the centre of the source, in the second half of the run.
  struct Extremes {
    double lowest = 0;
    double highest = 0;
  };
  [[nodiscard]] Extremes range_at_source() const;
  /// Peaks of the elevation at the source that reach the upper half of that range.
  [[nodiscard]] std::vector<CurveCrest> source_peaks() const;
  /// Of the elevation at the source, after its first peak; NaN without one.
  [[nodiscard]] Period period() const;

  /// How many peaks the last surface has beyond the front of the source; NaN where it is not known.
  [[nodiscard]] double soliton_count(double threshold) const;
  /// Highest elevation beyond the front of the source, of the last surface and of all times.
  [[nodiscard]] double maximum_ahead() const;
  [[nodiscard]] double maximum_ahead_ever() const { return ahead_ever_.value(); }
  /// Largest elevation at the wall ahead, at any time: as long as nothing gets there the channel is as good as endless.
  [[nodiscard]] double largest_at_wall() const { return at_wall_.value(); }
  /// The leading soliton: mean speed in the last `leader_time`, and height at the end; NaN without one.
  struct Leader {
    double speed = nan, height = nan;
  };
  [[nodiscard]] Leader leader(double threshold) const;

  /// Surfaces one above the other, time upwards, in the frame of the source.
  void draw_ridges(evidence::Figure& figure) const;
  void draw_at_source(evidence::Figure& figure) const;

  static constexpr double leader_time = 10;

 private:
  [[nodiscard]] std::vector<CurveCrest> solitons(const PressureSurface& surface, double threshold) const;

  PressureSource source_;
  std::vector<double> time_, at_source_;
  PressureSurface earlier_, last_;
  std::vector<PressureSurface> ridges_;
  Largest ahead_ever_;
  Worst at_wall_;
};

struct PressureRegime {
  std::string id;
  std::string name;
  PressureSource source;
  double time = 0;
  bool solitons = true;   ///< run ahead of the source
  bool periodic = false;  ///< the surface at the source, for four periods or more
};

/// The three regimes of the figure, solitons by pressure, solitons by suction, suction without solitons; and other
/// widths and strengths.
std::vector<PressureRegime> pressure_regimes(bool all = true);
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
