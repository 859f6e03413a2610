/// Waves of a flap in a flume of weakly compressible particles, and where their height is read.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/wcsph/flow.hpp"
#include "validation/case/case.hpp"
#include "validation/case/tape.hpp"
#include "validation/studies/wcsph/sph_settings.hpp"

namespace seiche::validation {

inline constexpr double flap_gravity = 9.81;
inline constexpr double flap_periods = 2.75;
inline constexpr std::size_t samples_per_period = 60;

struct FlapDesign {
  double depth, period, stroke, gauge;
};

FlapDesign flap_design(const Values& values);

/// What is changed in the settings that the parameters say.
struct FlapScheme {
  std::string name;
  void (*change)(wcsph::Settings&);
};
/// Places where the elevation is read, in distances of the gauge from the flap; the last is the gauge.
inline constexpr std::array places{0.15, 0.3, 0.5, 0.75, 1.0};
/// Elevations at each of the places.
using Elevations = std::array<std::vector<double>, places.size()>;

struct FlapWaves {
  std::string scheme;
  double neighbours = 0;  ///< of a particle
  double spacing = 0;
  long layers = 0;
  std::size_t particles = 0;
  std::vector<double> time;
  Elevations elevation;
  long behind = 0;                                                ///< particles outside the flume at the end
  double breaks_down = std::numeric_limits<double>::quiet_NaN();  ///< when [s]; NaN where it does not
  wcsph::Extremes extremes;
  long steps = 0;

  [[nodiscard]] std::string resolution() const {
    return fmt::format("{} layers, {}", layers, sph_resolution(spacing, particles));
  }
};

void exchange(Tape& tape, FlapWaves& waves);

/// @param may_break  that it breaks down is a result too; otherwise Divergence is thrown
FlapWaves make_flap_waves(const Run& run, const FlapDesign& design, long layers, const FlapScheme& scheme,
                          bool may_break, Part part);

/// Crest to trough in each period, the last one as far as it goes.
std::array<double, 3> heights_of(const std::vector<double>& time, const std::vector<double>& elevation, double period);

}  // namespace seiche::validation
