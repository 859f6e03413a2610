/// How far points of a surface are from a periodic wave that travels without a change of shape.
#pragma once

#include <functional>
#include <vector>

#include "seiche/geometry/curve.hpp"

namespace seiche::validation {

using Elevation = std::function<double(double from_crest)>;

/// Rms difference of the points' elevations from those of the wave whose crest is at `at`.
double surface_rms(const Elevation& wave, const std::vector<Point>& points, double at);

/// By how much the wave that fits best is ahead of that with its crest at `at`, in wavelengths: up to a twentieth.
double surface_lead(const Elevation& wave, double wavelength, const std::vector<Point>& points, double at);

/// The fundamental of a periodic surface beside that of a wave with its crest at `at`.
struct Fundamental {
  double height = 0;  ///< its amplitude over the wave's
  double lead = 0;    ///< how far it is ahead, in wavelengths, from -1/2 to 1/2
};

/// @param points  of one wavelength, ascending in x, three or more; between them straight lines, the last to the first
Fundamental surface_fundamental(const Elevation& wave, double wavelength, const std::vector<Point>& points, double at);

}  // namespace seiche::validation
