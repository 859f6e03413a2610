#include "validation/breakwater/berm_load.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>

#include "seiche/exact/dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"
#include "validation/breakwater/surface_modes.hpp"

namespace seiche::validation {

using lagrangian_mesh_2d::Mesh;
using lagrangian_mesh_2d::Model;

Mesh Berm::mesh(std::size_t columns, std::size_t rows, const std::function<double(double x)>& elevation) const {
  const auto scaled = [berm = *this](double x) { return (x + berm.width) / berm.steepness; };
  const auto slope = [scaled, berm = *this](double x) {
    const double c = std::cosh(scaled(x));
    return 0.5 * berm.rise / (berm.steepness * c * c);
  };
  const double panel = 0.05;  // short beside the front face: quadrature to round-off
  const auto bottom = std::make_shared<const GraphCurve>(
      [scaled, berm = *this](double x) { return -1 + 0.5 * berm.rise * (1 + std::tanh(scaled(x))); }, slope,
      [scaled, slope, berm = *this](double x) { return -2 * slope(x) * std::tanh(scaled(x)) / berm.steepness; },
      -length, 0.0, static_cast<std::size_t>(std::ceil(length / panel)));
  return lagrangian_mesh_2d::layer_mesh(
      {.begin = -length, .end = 0, .columns = columns, .rows = rows, .elevation = elevation, .bottom = bottom});
}

BermLoad berm_load(const Mesh& mesh, std::span<const double> y, std::span<const double> multipliers) {
  BermLoad load;
  for (std::size_t i = 0; i < mesh.columns; ++i) {
    load.front += multipliers[i] * (y[mesh.node(i + 1, 0)] - y[mesh.node(i, 0)]);
  }
  for (std::size_t j = 0; j < mesh.rows; ++j) {
    load.rear +=
        multipliers[(j + 1) * mesh.columns - 1] * (y[mesh.node(mesh.columns, j + 1)] - y[mesh.node(mesh.columns, j)]);
  }
  return load;
}

Berm berm_of(const Values& values) {
  return {.rise = 1 - values.real("berm_depth"), .width = values.real("berm_width")};
}
BermResolution berm_mesh_of(const Values& values) {
  return {values.real("columns_per_depth"), values.count("rows")};
}

std::vector<StandingLoad> standing_loads(const Berm& berm, const BermResolution& mesh, double shortest) {
  Model model(mesh.mesh(berm));
  const exact::AiryDispersion airy(1, 1);
  std::vector<StandingLoad> loads;
  for (const SurfaceMode& mode : surface_modes(model)) {
    const double k = airy.wavenumber(mode.frequency);
    if (2 * std::numbers::pi / k < shortest) break;
    const BermLoad load = berm_load(model.mesh(), model.mesh().y, mode.multipliers);
    const double unit = std::copysign(mode.elevation.front(), load.rear);
    loads.push_back({.wavelength = 2 * std::numbers::pi / k,
                     .force = {load.front / unit, load.rear / unit},
                     .plain_wall = std::tanh(k) / k});
  }
  return loads;
}

std::vector<StandingLoad> loads_by_wavelength(const Berm& berm, const BermResolution& mesh, double shortest,
                                              double longest) {
  std::vector<StandingLoad> all;
  for (int n = -4; n <= 4; ++n) {
    Berm other = berm;
    other.length += 0.5 * n;
    std::ranges::copy_if(standing_loads(other, mesh, shortest), std::back_inserter(all),
                         [&](const StandingLoad& one) { return one.wavelength <= longest; });
  }
  std::ranges::sort(all, {}, &StandingLoad::wavelength);
  return all;
}

BasinWave basin_wave(const Berm& berm, const BermResolution& mesh, double wavelength) {
  Model model(mesh.mesh(berm));
  const std::vector<StandingLoad> loads = standing_loads(berm, mesh, 3);
  const auto nearest = std::ranges::min_element(
      loads, {}, [&](const StandingLoad& one) { return std::abs(one.wavelength - wavelength); });
  return {.mode = surface_modes(model)[static_cast<std::size_t>(nearest - loads.begin())], .load = *nearest};
}

}  // namespace seiche::validation
