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

/// @param stiffness  gamma H^2/dx of a cell with this water and this width
template <class Stiffness>
std::vector<double> surface_of(std::span<const double> x, std::span<const double> y, std::span<const double> volume,
                               double period, const Stiffness& stiffness) {
  const std::size_t n = x.size();
  const std::size_t cells = volume.size();
  std::vector<double> diagonal(n, 0.0), coupling(cells, 0.0), push(n, 0.0);
  for (std::size_t j = 0; j < cells; ++j) {
    const std::size_t k = j + 1 < n ? j + 1 : 0;
    const double width = k > j ? x[k] - x[j] : x[k] + period - x[j];
    const double stiff = stiffness(volume[j], width);
    const double flux = (above - below) * stiff * (y[k] - y[j]);
    push[j] -= flux;
    push[k] += flux;
    diagonal[j] += 0.5 * width + below * stiff;
    diagonal[k] += 0.5 * width + below * stiff;
    coupling[j] = -below * stiff;
  }
  ChannelMatrix matrix;
  matrix.factor(cells == n, diagonal, coupling);
  matrix.solve(push, push);
  for (std::size_t i = 0; i < n; ++i) push[i] += y[i];
  return push;
}

}  // namespace

std::vector<double> water_surface(std::span<const double> x, std::span<const double> y, std::span<const double> volume,
                                  double gamma, double period) {
  const std::size_t cells = period > 0 ? x.size() : x.size() - 1;
  require_that(x.size() >= 3 && y.size() == x.size() && volume.size() == cells,
               "water_surface: {} places, {} elevations and {} volumes; allowed: n, n and "
               "n - 1 (n with a period), n at least 3",
               x.size(), y.size(), volume.size());
  return surface_of(x, y, volume, period,
                    [=](double water, double width) { return gamma * std::pow(water / width, 2) / width; });
}

std::vector<double> water_surface(const Flow& flow) {
  const Channel& channel = flow.model().channel();
  if (channel.gamma == 0) return {flow.y().begin(), flow.y().end()};
  const double s = channel.depth_power;
  const double reference = std::pow(channel.reference_depth, 2 - s);
  return surface_of(flow.x(), flow.y(), flow.model().rest_volumes(), channel.period, [&](double water, double width) {
    return channel.gamma * std::pow(water / width, s) * reference / width;
  });
}

std::vector<double> water_surface_at(const Flow& flow, std::span<const double> places) {
  return flow.interpolated(water_surface(flow), places);
}

double surface_of_wave(double gamma, double kh) {
  const double s = gamma * kh * kh;
  return (1 + above * s) / (1 + below * s);
}

double bound_second_harmonic(double alpha, double gamma, double power, double kh) {
  const double square = kh * kh;
  const double celerity = (1 + gamma * square) / (1 + alpha * square);  // squared
  return (celerity + (alpha * celerity + gamma * power) * square) / (4 * (1 - celerity));
}

}  // namespace seiche::dispersive_shallow_water_1d
