#include "validation/instruments/plan/row_crests.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

namespace seiche::validation {
namespace {

/// Value at s of the polynomial through points (Lagrange).
template <std::size_t N>
double interpolated(const std::array<double, N>& abscissae, const std::array<double, N>& values, double s) {
  double sum = 0;
  for (std::size_t k = 0; k < N; ++k) {
    double product = values[k];
    for (std::size_t m = 0; m < N; ++m) {
      if (m != k) product *= (s - abscissae[m]) / (abscissae[k] - abscissae[m]);
    }
    sum += product;
  }
  return sum;
}

void require_size(const char* name, std::span<const double> values, std::size_t nodes) {
  if (values.size() != nodes) {
    throw std::invalid_argument(
        fmt::format("surface grid: {} has {} values, must have {}: one for each node", name, values.size(), nodes));
  }
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (bad != values.end()) {
    throw std::invalid_argument(
        fmt::format("surface grid: {} of node {} is {}, must be finite", name, bad - values.begin(), *bad));
  }
}

}  // namespace

void require_complete(const SurfaceLattice& surface) {
  if (surface.columns < 4 || surface.rows < 4) {
    throw std::invalid_argument(
        fmt::format("surface grid of {} by {} cells: must be at least 4 by 4", surface.columns, surface.rows));
  }
  const std::size_t nodes = (surface.columns + 1) * (surface.rows + 1);
  require_size("x", surface.x, nodes);
  require_size("y", surface.y, nodes);
  require_size("z", surface.z, nodes);
}

Crest refined_crest(const SurfaceLattice& surface, std::size_t column, std::size_t j, double lean) {
  const std::size_t top = surface.node(column, j);
  const auto along = [&](std::size_t n) {
    return (surface.x[n] - surface.x[top]) - lean * (surface.y[n] - surface.y[top]);
  };
  const double left = along(top - 1);
  const double right = along(top + 1);
  if (!(left < 0 && right > 0)) {
    throw std::invalid_argument(
        fmt::format("row {} of the surface does not advance along the wall at column {}: x = {:g}, {:g}, {:g}; "
                    "allowed: increasing, as in waves that do not overturn",
                    j, column, surface.x[top - 1], surface.x[top], surface.x[top + 1]));
  }
  const double slope_left = (surface.z[top - 1] - surface.z[top]) / left;
  const double slope_right = (surface.z[top + 1] - surface.z[top]) / right;
  const double curvature = (slope_right - slope_left) / (right - left);
  Crest crest{surface.x[top], surface.y[top], surface.z[top], column};
  if (!(curvature < 0)) return crest;
  const double slope = slope_left - curvature * left;
  const double s = std::clamp(-slope / (2 * curvature), left, right);
  const std::array<double, 3> abscissae{left, 0, right};
  crest.x = interpolated(abscissae, {surface.x[top - 1], surface.x[top], surface.x[top + 1]}, s);
  crest.y = interpolated(abscissae, {surface.y[top - 1], surface.y[top], surface.y[top + 1]}, s);
  crest.height = surface.z[top] + s * (slope + s * curvature);
  return crest;
}

std::vector<Crest> row_crests(const SurfaceLattice& surface, std::size_t j, double threshold) {
  std::vector<Crest> crests;
  for (std::size_t i = surface.columns - 1; i > 0; --i) {
    const std::size_t n = surface.node(i, j);
    // Of two equal nodes the one behind is the crest.
    if (surface.z[n] > threshold && surface.z[n] >= surface.z[n + 1] && surface.z[n] > surface.z[n - 1]) {
      crests.push_back(refined_crest(surface, i, j, 0));
    }
  }
  return crests;
}

double five_node_height(const SurfaceLattice& surface, const Crest& crest, std::size_t j) {
  const std::size_t first = std::clamp<std::size_t>(crest.column, 2, surface.columns - 2) - 2;
  std::array<double, 5> s{};
  std::array<double, 5> z{};
  for (std::size_t k = 0; k < 5; ++k) {
    const std::size_t n = surface.node(first + k, j);
    s[k] = surface.x[n] - crest.x;
    z[k] = surface.z[n];
  }
  const double reach = 0.25 * (s[4] - s[0]);
  return -boost::math::tools::brent_find_minima([&](double at) { return -interpolated(s, z, at); }, -reach, reach, 30)
              .second;
}

Crest wall_crest(const SurfaceLattice& surface, double threshold) {
  const std::vector<Crest> crests = row_crests(surface, 0, threshold);
  if (crests.empty()) throw std::runtime_error(fmt::format("no crest on the wall is higher than {:g}", threshold));
  return crests.front();
}

}  // namespace seiche::validation
