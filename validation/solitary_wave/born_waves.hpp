/// Solitary waves that a hump of water at the end of a long tank gives birth to, on the two-dimensional Lagrangian
/// mesh. Depth and gravity are 1.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/instruments/crest_track.hpp"
#include "validation/instruments/mesh_solitary_wave.hpp"

namespace seiche::validation {

inline constexpr double birth_tank = 170;  // length
inline constexpr double birth_duration = 130;
inline constexpr double birth_separated = 65;  // from then on the crest is measured
inline constexpr double birth_reach = 6;       // of the profile, from the crest

/// a0 sech^2(x/w).
struct Hump {
  double height, width;
};
inline constexpr std::array<Hump, 4> starts{{{0.39, 3}, {0.56, 3}, {0.77, 3}, {0.98, 2.7}}};

struct Born {
  CrestTrack track;
  double amplitude = 0;
  double speed = 0;
  double from_exact = 0;    ///< largest distance of the profile from the exact wave as high as its crest
  double from_laitone = 0;  ///< the same, second approximation

  [[nodiscard]] double end_amplitude() const { return track.elevation.back(); }
};

lagrangian_mesh_2d::Flow raised(const Hump& hump, const MeshResolution& mesh, double hourglass);

/// Follows the crest to the end.
Born follow(lagrangian_mesh_2d::Flow& flow, double tau, const std::function<void()>& after_step = {});

/// All starts on one mesh.
struct Family {
  std::string label;
  MeshResolution mesh;
  std::vector<Born> waves;

  [[nodiscard]] std::vector<double> amplitudes() const {
    std::vector<double> values;
    for (const Born& wave : waves) values.push_back(wave.amplitude);
    return values;
  }
  /// A quantity at a height, linear between the waves.
  template <class Quantity>
  [[nodiscard]] double at(double amplitude, const Quantity& quantity) const {
    std::size_t k = 1;
    while (k + 1 < waves.size() && waves[k].amplitude < amplitude) ++k;
    const Born& low = waves[k - 1];
    const Born& high = waves[k];
    const double w = (amplitude - low.amplitude) / (high.amplitude - low.amplitude);
    return (1 - w) * quantity(low) + w * quantity(high);
  }
  [[nodiscard]] double speed_at(double amplitude) const {
    return at(amplitude, [](const Born& wave) { return wave.speed; });
  }
};

}  // namespace seiche::validation
