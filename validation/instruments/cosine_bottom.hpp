/// A corrugated bottom with exact means: for lakes at rest and conservation over a bottom that is level nowhere.
#pragma once

#include <optional>
#include <span>

#include "seiche/geometry/bottom_profile.hpp"

namespace seiche {

/// b = -depth + amplitude cos(wavenumber x + phase).
class CosineBottom final : public BottomProfile {
 public:
  /// @param depth  [m]. @param wavenumber  [1/m]. Throws std::invalid_argument unless depth and wavenumber are
  /// positive.
  CosineBottom(double depth, double amplitude, double wavenumber, double phase = 0);
  void sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const override;
  [[nodiscard]] double mean(double from, double to) const override;
  [[nodiscard]] double mean_square(double from, double to) const override;
  [[nodiscard]] std::optional<double> uniform_slope(double, double) const override { return std::nullopt; }

 private:
  double depth_, amplitude_, wavenumber_, phase_;
};

}  // namespace seiche
