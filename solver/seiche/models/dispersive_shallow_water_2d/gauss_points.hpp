/// Gauss's rule of three points on [0, 1].
#pragma once

#include <array>
#include <cmath>

namespace seiche::dispersive_shallow_water_2d {

struct GaussPoint {
  double t;
  double weight;
};

inline const std::array<GaussPoint, 3>& gauss_points() {
  static const double half = 0.5 * std::sqrt(0.6);
  static const std::array points{GaussPoint{0.5 - half, 5.0 / 18}, GaussPoint{0.5, 8.0 / 18},
                                 GaussPoint{0.5 + half, 5.0 / 18}};
  return points;
}

}  // namespace seiche::dispersive_shallow_water_2d
