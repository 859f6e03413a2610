/// A solitary wave runs along a channel over a smooth round shoal, by both models of waves in three dimensions.
///
/// Units: depth away from the shoal and gravity are 1; z counts from still water. The channel is begin <= x <= end,
/// 0 <= y <= width, all its sides walls; the shoal's top is on the wall y = 0, which mirrors it.
#pragma once

#include <array>
#include <memory>

#include "seiche/geometry/plan_bottom.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/peak.hpp"

namespace seiche::validation {

struct ShoalWave {
  static constexpr double begin = -5;
  static constexpr double end = 30;
  static constexpr double width = 6;
  static constexpr double crest = 5;   ///< of the wave at the start
  static constexpr double top = 17;    ///< of the shoal
  static constexpr double radius = 4;  ///< of the shoal

  double amplitude = 0.2;
  double height = 0.4;     ///< of the shoal
  std::size_t layers = 3;  ///< of the hexahedral mesh, whose cells are as long and as wide as a layer is high
  double time = 14;

  [[nodiscard]] double spacing() const { return 1 / static_cast<double>(layers); }
  [[nodiscard]] double tau() const { return 0.4 * spacing(); }
  /// z = -1 + height (1 - (r/radius)^2)^3 within the radius, as a spline that both models see.
  [[nodiscard]] std::shared_ptr<const PlanBottom> bottom() const;
};

/// Where elevations are taken, on the walls: over the top and behind it on the shoal's side, beside the shoal across.
struct ShoalGauge {
  const char* id;
  const char* name;
  double x;
  bool across;
};
inline constexpr std::array<ShoalGauge, 3> shoal_gauges{{{"top", "over the top of the shoal", ShoalWave::top, false},
                                                         {"lee", "two depths behind it", ShoalWave::top + 2, false},
                                                         {"beside", "across, beside the top", ShoalWave::top, true}}};

struct ShoalRun {
  std::array<Peak, 3> highest;  ///< at the gauges
  std::array<std::vector<double>, 3> elevation;
  std::vector<double> time;
  Worst energy_defect;  ///< relative
};

/// From the solitary wave of the Euler equations on the hexahedral mesh, from that of the Green-Naghdi equations in
/// plan; spacing and steps are the same.
ShoalRun run_hexahedra(const ShoalWave& wave);
ShoalRun run_plan(const ShoalWave& wave);

}  // namespace seiche::validation
