/// A corrugated bottom with exact means: for lakes at rest and conservation over a bottom that is level nowhere.
#pragma once

#include <cmath>

#include <optional>
#include <span>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/require.hpp"

namespace seiche {

/// b = -depth + amplitude cos(wavenumber x + phase).
class CosineBottom final : public BottomProfile {
 public:
  /// @param depth  [m]. @param wavenumber  [1/m]. Throws std::invalid_argument unless depth and wavenumber are
  /// positive.
  CosineBottom(double depth, double amplitude, double wavenumber, double phase = 0)
      : depth_(depth), amplitude_(amplitude), wavenumber_(wavenumber), phase_(phase) {
    require_positive("depth", depth);
    require_finite("amplitude", amplitude);
    require_positive("wavenumber", wavenumber);
    require_finite("phase", phase);
  }
  void sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const override {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double angle = wavenumber_ * x[i] + phase_;
      elevation[i] = -depth_ + amplitude_ * std::cos(angle);
      slope[i] = -amplitude_ * wavenumber_ * std::sin(angle);
    }
  }
  [[nodiscard]] double mean(double from, double to) const override {
    const double middle = wavenumber_ * (0.5 * (from + to)) + phase_;
    return -depth_ + amplitude_ * mean_cosine(middle, 0.5 * wavenumber_ * (to - from));
  }
  [[nodiscard]] double mean_square(double from, double to) const override {
    const double middle = wavenumber_ * (0.5 * (from + to)) + phase_;
    const double half = 0.5 * wavenumber_ * (to - from);
    const double square = 0.5 * (1 + mean_cosine(2 * middle, 2 * half));  // of the cosine
    return depth_ * depth_ - 2 * depth_ * amplitude_ * mean_cosine(middle, half) + amplitude_ * amplitude_ * square;
  }
  [[nodiscard]] std::optional<double> uniform_slope(double, double) const override { return std::nullopt; }

 private:
  /// Mean of cos over an interval of the angle: cos at its middle times sin(h)/h, h half its length.
  static double mean_cosine(double middle, double half) {
    const double sinc = std::abs(half) < 1e-4 ? 1 - half * half / 6 : std::sin(half) / half;
    return std::cos(middle) * sinc;
  }

  double depth_, amplitude_, wavenumber_, phase_;
};

}  // namespace seiche
