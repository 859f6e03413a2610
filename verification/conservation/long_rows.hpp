/// Shallow water in rows that a step goes through piece by piece, on threads: cells and particles one metre wide.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"

namespace seiche::verification {

/// Water over [begin, end) of a longer channel with friction, a slope where the scheme takes one: waves, and a jump at
/// x = 2500.
inline shallow_water_finite_volume::FiniteVolumeFlow long_channel(shallow_water_finite_volume::Scheme scheme,
                                                                  std::size_t begin, std::size_t end) {
  std::optional<Bed> bed;
  if (scheme == shallow_water_finite_volume::Scheme::muscl_hll) {
    constexpr double slope = 1.0 / 4096;
    bed = Bed{[](double x) { return slope * x; }, [](double x) { return slope * x * x / 2; }};
  }
  std::vector<double> depth, discharge;
  for (std::size_t i = begin; i < end; ++i) {
    const auto x = static_cast<double>(i);
    depth.push_back(1.5 + 0.2 * std::sin(x / 7) + (i < 2500 ? 0.5 : 0));
    discharge.push_back(0.3 * std::cos(x / 5));
  }
  return {
      {.scheme = scheme, .manning = 0.02}, static_cast<double>(begin), static_cast<double>(end), depth, discharge, bed};
}

/// Ripples as long as a few particles, over the particles [begin, end) of a longer row.
inline shallow_water_particles::Particles ripples(std::size_t begin, std::size_t end) {
  shallow_water_particles::Particles row;
  for (std::size_t k = begin; k <= end; ++k) row.edge.push_back(static_cast<double>(k));
  for (std::size_t i = begin; i < end; ++i) {
    const auto x = static_cast<double>(i);
    row.mass.push_back(1.5 + 0.01 * std::sin(x / 7));
    row.velocity.push_back(0.02 * std::cos(x / 5));
  }
  return row;
}

}  // namespace seiche::verification
