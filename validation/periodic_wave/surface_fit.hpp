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

}  // namespace seiche::validation
