#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require_that.hpp"
#include "seiche/shallow_water/dispersive_surface.hpp"

namespace seiche::dispersive_shallow_water_1d {
namespace {

constexpr double above = DispersiveSurface::above;
constexpr double below = DispersiveSurface::below;

}  // namespace

std::vector<double> water_surface(const Channel& channel, std::span<const double> x, std::span<const double> y,
                                  std::span<const double> volume) {
  const std::size_t n = x.size();
  const std::size_t cells = channel.periodic() ? n : n - 1;
  require_that(n >= 3 && y.size() == n && volume.size() == cells,
               "water_surface: {} places, {} elevations and {} volumes; allowed: n, n and "
               "n - 1 (n with a period), n at least 3",
               n, y.size(), volume.size());
  const double reference = std::pow(channel.reference_depth, 2 - channel.depth_power);
  std::vector<double> diagonal(n, 0.0), coupling(cells, 0.0), push(n, 0.0);
  for (std::size_t j = 0; j < cells; ++j) {
    const std::size_t k = j + 1 < n ? j + 1 : 0;
    const double width = k > j ? x[k] - x[j] : x[k] + channel.period - x[j];
    // gamma H^2/dx
    const double stiff = channel.gamma * std::pow(volume[j] / width, channel.depth_power) * reference / width;
    const double flux = (above - below) * stiff * (y[k] - y[j]);
    push[j] -= flux;
    push[k] += flux;
    diagonal[j] += 0.5 * width + below * stiff;
    diagonal[k] += 0.5 * width + below * stiff;
    coupling[j] = -below * stiff;
  }
  linear::TwoEndedTridiagonal matrix;
  matrix.factor({diagonal, coupling}, channel.periodic());
  matrix.solve(push, push);
  for (std::size_t i = 0; i < n; ++i) push[i] += y[i];
  return push;
}

std::vector<double> water_surface(const Flow& flow) {
  const Channel& channel = flow.model().channel();
  if (channel.gamma == 0) return {flow.y().begin(), flow.y().end()};
  return water_surface(channel, flow.x(), flow.y(), flow.model().rest_volumes());
}

std::vector<double> water_surface_at(const Flow& flow, std::span<const double> places) {
  return flow.interpolated(water_surface(flow), places);
}

}  // namespace seiche::dispersive_shallow_water_1d
