#include "validation/periodic_wave/surface_fit.hpp"

#include <cmath>

#include "seiche/samples.hpp"

namespace seiche::validation {

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

}  // namespace seiche::validation
