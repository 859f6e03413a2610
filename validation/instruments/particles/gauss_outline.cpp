#include "validation/instruments/particles/gauss_outline.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"
#include "validation/instruments/particles/sph_free_surface.hpp"

namespace seiche::gauss_particles {

namespace {

constexpr double most_points = 1e8;

/// Smoothed density over that of the water, on a grid with an empty rim.
wcsph::Raster smoothed(const wcsph::Particles& water, double spacing) {
  const double width = 1.5 * spacing;
  const wcsph::VolumeFraction fraction(water, width, wcsph::unbounded, wcsph::KernelName::wendland_c2);
  const wcsph::Box& of = fraction.extents();
  const double rim = wcsph::support * width + spacing;
  wcsph::Raster grid{.left = of.left - rim, .bottom = of.bottom - rim, .step = spacing / 2};
  const double columns = std::ceil((of.right - of.left + 2 * rim) / grid.step) + 1;
  const double rows = std::ceil((of.top - of.bottom + 2 * rim) / grid.step) + 1;
  if (!(columns * rows <= most_points)) {
    throw std::invalid_argument(
        fmt::format("{:.3g} points of a grid; allowed: at most {:g}", columns * rows, most_points));
  }
  grid.columns = static_cast<long>(columns);
  grid.rows = static_cast<long>(rows);
  grid.values = fraction.on_grid(grid.left, grid.bottom, grid.step, grid.columns, grid.rows);
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
  wcsph::Particles water;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (mass[k] != 0) water.add(x[k], y[k], mass[k], density);
  }
  std::vector<std::vector<Point>> contours;
  for (const wcsph::Contour& curve : wcsph::level_curves(smoothed(water, spacing), 0.5)) {
    std::vector<Point>& line = contours.emplace_back();
    for (std::size_t k = curve.x.size(); k-- > 0;) line.push_back({curve.x[k], curve.z[k]});
  }
  return contours;
}

}  // namespace seiche::gauss_particles
