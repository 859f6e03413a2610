#include "validation/periodic_wave/surface_fit.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

/// Of the periodic function through the points, by the trapezoidal rule.
std::complex<double> first_coefficient(const std::vector<Point>& points, double wavelength, double origin) {
  const double k = 2 * std::numbers::pi / wavelength;
  const std::size_t n = points.size();
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i == 0 ? points[n - 1].x - wavelength : points[i - 1].x;
    const double after = i + 1 == n ? points[0].x + wavelength : points[i + 1].x;
    sum += 0.5 * (after - before) * points[i].y * std::polar(1.0, -k * (points[i].x - origin));
  }
  return sum;
}

}  // namespace

double surface_rms(const Elevation& wave, const std::vector<Point>& points, double at) {
  Mean squares;
  for (const Point& point : points) squares.add(point.y - wave(point.x - at));
  return squares.rms();
}

double surface_lead(const Elevation& wave, double wavelength, const std::vector<Point>& points, double at) {
  const double part = (std::sqrt(5.0) - 1) / 2;  // golden section
  double low = -0.05 * wavelength;
  double high = 0.05 * wavelength;
  while (high - low > 1e-9 * wavelength) {
    const double left = high - part * (high - low);
    const double right = low + part * (high - low);
    if (surface_rms(wave, points, at + left) < surface_rms(wave, points, at + right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return 0.5 * (low + high) / wavelength;
}

Fundamental surface_fundamental(const Elevation& wave, double wavelength, const std::vector<Point>& points, double at) {
  if (points.size() < 3) {
    throw std::invalid_argument(
        fmt::format("fundamental of a surface: {} points, must be three or more", points.size()));
  }
  constexpr int samples = 2000;
  std::vector<Point> exact;
  for (int i = 0; i < samples; ++i) {
    const double x = wavelength * i / samples;
    exact.push_back({x, wave(x)});
  }
  const std::complex<double> ratio =
      first_coefficient(points, wavelength, at) / first_coefficient(exact, wavelength, 0);
  return {std::abs(ratio), -std::arg(ratio) / (2 * std::numbers::pi)};
}

}  // namespace seiche::validation
