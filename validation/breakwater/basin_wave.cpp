#include "validation/breakwater/basin_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace seiche::validation {

std::size_t BermResolution::columns(const Berm& berm) const {
  return static_cast<std::size_t>(std::lround(columns_per_depth * berm.length));
}

BermResolution BermResolution::times(double factor) const {
  return {columns_per_depth * factor, static_cast<std::size_t>(std::lround(factor * static_cast<double>(rows)))};
}

const StandingLoad& nearest(const std::vector<StandingLoad>& loads, double wavelength) {
  return *std::ranges::min_element(loads, {},
                                   [&](const StandingLoad& one) { return std::abs(one.wavelength - wavelength); });
}

BasinWave basin_wave(const Berm& berm, const BermResolution& mesh, double wavelength) {
  constexpr double shortest = 3;
  lagrangian_mesh_2d::Model model(berm.mesh(mesh.columns(berm), mesh.rows));
  const std::vector<StandingLoad> loads = standing_loads(berm, mesh.columns(berm), mesh.rows, shortest);
  const StandingLoad& load = nearest(loads, wavelength);
  return {.mode = surface_modes(model)[static_cast<std::size_t>(&load - loads.data())], .load = load};
}

}  // namespace seiche::validation
