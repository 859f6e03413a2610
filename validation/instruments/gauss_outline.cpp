#include "seiche/models/gauss_particles/surface_contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::gauss_particles {

namespace {

constexpr double most_points = 1e8;
constexpr double level = 0.5;

/// Smoothed density over that of the water, on a grid with an empty rim.
struct Grid {
  double left = 0;
  double low = 0;
  double cell = 1;
  std::size_t columns = 0;  ///< of points
  std::size_t rows = 0;
  std::vector<double> value = {};

  [[nodiscard]] std::size_t point(std::size_t i, std::size_t j) const { return i * rows + j; }
};

Grid smoothed(std::span<const double> x, std::span<const double> y, std::span<const double> mass, double density,
              double spacing) {
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
  Grid grid{.left = left - reach - spacing, .low = low - reach - spacing, .cell = spacing / 2};
  const double columns = std::ceil((right - left + 2 * (reach + spacing)) / grid.cell) + 1;
  const double rows = std::ceil((high - low + 2 * (reach + spacing)) / grid.cell) + 1;
  if (!(columns * rows <= most_points)) {
    throw std::invalid_argument(
        fmt::format("{:.3g} points of a grid; allowed: at most {:g}", columns * rows, most_points));
  }
  grid.columns = static_cast<std::size_t>(columns);
  grid.rows = static_cast<std::size_t>(rows);
  grid.value.assign(grid.columns * grid.rows, 0.0);
  const double scale = 7 / (4 * std::numbers::pi * width * width * density);
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (mass[k] == 0) continue;
    const auto from = [&](double place, double begin) {
      return static_cast<std::size_t>(std::ceil((place - reach - begin) / grid.cell));
    };
    for (std::size_t i = from(x[k], grid.left); grid.left + grid.cell * static_cast<double>(i) < x[k] + reach; ++i) {
      for (std::size_t j = from(y[k], grid.low); grid.low + grid.cell * static_cast<double>(j) < y[k] + reach; ++j) {
        const double q = std::hypot(grid.left + grid.cell * static_cast<double>(i) - x[k],
                                    grid.low + grid.cell * static_cast<double>(j) - y[k]) /
                         width;
        if (q < 2) grid.value[grid.point(i, j)] += mass[k] * scale * std::pow(1 - q / 2, 4) * (2 * q + 1);
      }
    }
  }
  return grid;
}

/// Edge 2 p goes from point p along x, edge 2 p + 1 along y.
Point crossing(const Grid& grid, std::size_t edge) {
  const std::size_t p = edge / 2;
  const bool up = edge % 2 == 1;
  const std::size_t to = up ? p + 1 : p + grid.rows;
  const double part = (level - grid.value[p]) / (grid.value[to] - grid.value[p]);
  const std::size_t column = p / grid.rows;
  const std::size_t row = p % grid.rows;
  const double i = static_cast<double>(column) + (up ? 0 : part);
  const double j = static_cast<double>(row) + (up ? part : 0);
  return {grid.left + grid.cell * i, grid.low + grid.cell * j};
}

/// For every edge that the line crosses, the edge it crosses next; none elsewhere.
std::vector<std::size_t> successors(const Grid& grid, std::size_t none) {
  std::vector<std::size_t> next(2 * grid.value.size(), none);
  for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
    for (std::size_t j = 0; j + 1 < grid.rows; ++j) {
      // Corners against the clock from the lower left one, and the edges between them.
      const std::array<std::size_t, 4> corner{grid.point(i, j), grid.point(i + 1, j), grid.point(i + 1, j + 1),
                                              grid.point(i, j + 1)};
      const std::array<std::size_t, 4> edge{2 * corner[0], 2 * corner[1] + 1, 2 * corner[3], 2 * corner[0] + 1};
      std::array<bool, 4> wet{};
      double sum = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        wet[c] = grid.value[corner[c]] > level;
        sum += grid.value[corner[c]];
      }
      const bool two_corners = wet[0] == wet[2] && wet[1] == wet[3] && wet[0] != wet[1];
      for (std::size_t c = 0; c < 4; ++c) {
        // The line enters where, against the clock, wet becomes dry, and goes round the wet corners behind.
        if (!wet[c] || wet[(c + 1) % 4]) continue;
        std::size_t out = (c + 3) % 4;
        if (two_corners && sum / 4 > level) {
          out = (c + 1) % 4;
        } else {
          while (wet[out]) out = (out + 3) % 4;
        }
        next[edge[c]] = edge[out];
      }
    }
  }
  return next;
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
  const Grid grid = smoothed(x, y, mass, density, spacing);
  const std::size_t none = 2 * grid.value.size();
  std::vector<std::size_t> next = successors(grid, none);
  std::vector<std::vector<Point>> contours;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (next[start] == none) continue;
    std::vector<Point>& line = contours.emplace_back();
    for (std::size_t edge = start; next[edge] != none;) {
      line.push_back(crossing(grid, edge));
      const std::size_t following = next[edge];
      next[edge] = none;
      edge = following;
    }
  }
  return contours;
}

}  // namespace seiche::gauss_particles
