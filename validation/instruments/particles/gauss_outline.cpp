#include "validation/instruments/particles/gauss_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"

namespace seiche::gauss_particles {

namespace {

constexpr double most_points = 1e8;

/// Smoothed density over that of the water, on a grid with an empty rim.
wcsph::Raster smoothed(std::span<const double> x, std::span<const double> y, std::span<const double> mass,
                       double density, double spacing) {
  const double width = 1.5 * spacing;
  const double reach = 2 * width;
  double left = 0;
  double right = 0;
  double low = 0;
  double high = 0;
  bool first = true;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (mass[k] == 0) continue;
    left = first ? x[k] : std::min(left, x[k]);
    right = first ? x[k] : std::max(right, x[k]);
    low = first ? y[k] : std::min(low, y[k]);
    high = first ? y[k] : std::max(high, y[k]);
    first = false;
  }
  wcsph::Raster grid{.left = left - reach - spacing, .bottom = low - reach - spacing, .step = spacing / 2};
  const double columns = std::ceil((right - left + 2 * (reach + spacing)) / grid.step) + 1;
  const double rows = std::ceil((high - low + 2 * (reach + spacing)) / grid.step) + 1;
  if (!(columns * rows <= most_points)) {
    throw std::invalid_argument(
        fmt::format("{:.3g} points of a grid; allowed: at most {:g}", columns * rows, most_points));
  }
  grid.columns = static_cast<long>(columns);
  grid.rows = static_cast<long>(rows);
  grid.values.assign(static_cast<std::size_t>(grid.columns * grid.rows), 0.0);
  const double scale = 7 / (4 * std::numbers::pi * width * width * density);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (mass[k] == 0) continue;
    const auto from = [&](double place, double begin) {
      return static_cast<long>(std::ceil((place - reach - begin) / grid.step));
    };
    for (long i = from(x[k], grid.left); grid.left + grid.step * static_cast<double>(i) < x[k] + reach; ++i) {
      for (long j = from(y[k], grid.bottom); grid.bottom + grid.step * static_cast<double>(j) < y[k] + reach; ++j) {
        const double q = std::hypot(grid.left + grid.step * static_cast<double>(i) - x[k],
                                    grid.bottom + grid.step * static_cast<double>(j) - y[k]) /
                         width;
        if (q >= 2) continue;
        grid.values[static_cast<std::size_t>(j * grid.columns + i)] +=
            mass[k] * scale * std::pow(1 - q / 2, 4) * (2 * q + 1);
      }
    }
  }
  return grid;
}

}  // namespace

std::vector<std::vector<Point>> surface_contours(std::span<const double> x, std::span<const double> y,
                                                 std::span<const double> mass, double density, double spacing) {
  if (x.size() != y.size() || x.size() != mass.size()) {
    throw std::invalid_argument(
        fmt::format("{} x, {} y, {} masses; allowed: as many of each", x.size(), y.size(), mass.size()));
  }
  require_positive("density", density);
  require_positive("spacing", spacing);
  std::vector<std::vector<Point>> contours;
  for (const wcsph::Contour& curve : wcsph::level_curves(smoothed(x, y, mass, density, spacing), 0.5)) {
    std::vector<Point>& line = contours.emplace_back();
    for (std::size_t k = curve.x.size(); k-- > 0;) line.push_back({curve.x[k], curve.z[k]});
  }
  return contours;
}

}  // namespace seiche::gauss_particles
