#include "seiche/models/dispersive_shallow_water_1d/water_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/shallow_water/dispersive_surface.hpp"

namespace seiche::dispersive_shallow_water_1d {
namespace {

constexpr double above = DispersiveSurface::above;
constexpr double below = DispersiveSurface::below;

/// With gamma H^2/dx of every cell.
std::vector<double> surface_of(std::span<const double> x, std::span<const double> y, std::span<const double> stiffness,
                               double period) {
  const std::size_t n = x.size();
  const std::size_t cells = stiffness.size();
  std::vector<double> diagonal(n, 0.0), coupling(cells, 0.0), push(n, 0.0);
  for (std::size_t j = 0; j < cells; ++j) {
    const std::size_t k = j + 1 < n ? j + 1 : 0;
    const double width = k > j ? x[k] - x[j] : x[k] + period - x[j];
    const double flux = (above - below) * stiffness[j] * (y[k] - y[j]);
    push[j] -= flux;
    push[k] += flux;
    diagonal[j] += 0.5 * width + below * stiffness[j];
    diagonal[k] += 0.5 * width + below * stiffness[j];
    coupling[j] = -below * stiffness[j];
  }
  if (cells == n) {
    linear::PeriodicTridiagonal matrix;
    matrix.factor({diagonal, coupling});
    matrix.solve(push, push);
  } else {
    linear::TwoEndedTridiagonal matrix;
    matrix.factor({diagonal, coupling});
    matrix.solve(push, push);
  }
  std::vector<double> surface(y.begin(), y.end());
  for (std::size_t i = 0; i < n; ++i) surface[i] += push[i];
  return surface;
}

}  // namespace

std::vector<double> water_surface(std::span<const double> x, std::span<const double> y, std::span<const double> volume,
                                  double gamma, double period) {
  const std::size_t cells = period > 0 ? x.size() : x.size() - 1;
  if (x.size() < 3 || y.size() != x.size() || volume.size() != cells) {
    throw std::invalid_argument(
        fmt::format("water_surface: {} places, {} elevations and {} volumes; allowed: n, n and "
                    "n - 1 (n with a period), n at least 3",
                    x.size(), y.size(), volume.size()));
  }
  std::vector<double> stiffness(cells);
  for (std::size_t j = 0; j < cells; ++j) {
    const double width = j + 1 < x.size() ? x[j + 1] - x[j] : x[0] + period - x[j];
    stiffness[j] = gamma * std::pow(volume[j] / width, 2) / width;
  }
  return surface_of(x, y, stiffness, period);
}

std::vector<double> water_surface(const Flow& flow) {
  const Channel& channel = flow.model().channel();
  const std::span<const double> x = flow.x();
  const std::span<const double> y = flow.y();
  if (channel.gamma == 0) return {y.begin(), y.end()};
  const std::span<const double> volume = flow.model().rest_volumes();
  std::vector<double> stiffness(volume.size());
  for (std::size_t j = 0; j < volume.size(); ++j) {
    const double width = j + 1 < x.size() ? x[j + 1] - x[j] : x[0] + channel.period - x[j];
    const double s = channel.depth_power;
    stiffness[j] = channel.gamma * std::pow(volume[j] / width, s) * std::pow(channel.reference_depth, 2 - s) / width;
  }
  return surface_of(x, y, stiffness, channel.period);
}

std::vector<double> water_surface_at(const Flow& flow, std::span<const double> places) {
  std::vector<double> elevation = flow.elevation_at(places);
  const Channel& channel = flow.model().channel();
  if (channel.gamma == 0) return elevation;
  // What the surface has beyond the markers, between them.
  const std::span<const double> x = flow.x();
  const std::span<const double> y = flow.y();
  const std::vector<double> surface = water_surface(flow);
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    double place = places[i];
    if (channel.periodic()) place -= channel.period * std::floor((place - x[0]) / channel.period);
    const auto k = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), place) - x.begin());
    if (k == 0 || (k == n && !channel.periodic())) continue;
    const std::size_t next = k < n ? k : 0;
    const double width = k < n ? x[k] - x[k - 1] : x[0] + channel.period - x[n - 1];
    const double share = (place - x[k - 1]) / width;
    elevation[i] += (1 - share) * (surface[k - 1] - y[k - 1]) + share * (surface[next] - y[next]);
  }
  return elevation;
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
