/// A standing wave of a basin over a berm, picked by its wavelength, and the mesh it lives on.
#pragma once

#include <numbers>

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "validation/breakwater/berm_load.hpp"
#include "validation/breakwater/surface_modes.hpp"

namespace seiche::validation {

struct BermResolution {
  double columns_per_depth;
  std::size_t rows;

  [[nodiscard]] std::size_t columns(const Berm& berm) const;
  [[nodiscard]] BermResolution times(double factor) const;
  /// "112 x 6 cells"
  [[nodiscard]] std::string name(const Berm& berm) const { return fmt::format("{} x {} cells", columns(berm), rows); }
};

/// Of the same wave on another mesh: the one of nearly that length.
const StandingLoad& nearest(const std::vector<StandingLoad>& loads, double wavelength);

struct BasinWave {
  SurfaceMode mode;
  StandingLoad load;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / mode.frequency; }
  /// 1 where the rear wall is pushed when the water is high at the far wall, -1 when it is low.
  [[nodiscard]] double sense() const { return mode.multipliers.back() * mode.elevation.front() > 0 ? 1 : -1; }
};

/// The wave of nearly this length among those longer than three depths.
BasinWave basin_wave(const Berm& berm, const BermResolution& mesh, double wavelength);

}  // namespace seiche::validation
