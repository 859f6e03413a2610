/// What an edge sweeps on its way from one place to another: the quadrilateral of its old and new ends, by Gauss's rule
/// of 2 x 2 points.
#pragma once

#include <array>
#include <numbers>

#include "seiche/geometry/curve.hpp"

namespace seiche {

/// A point of the rule.
struct SweptPoint {
  double s, t;  ///< in the quadrilateral: s from corner 0 to 1, t from corner 0 to 3
  Point place;
  double area;  ///< its part, with the sign of corners that go around anticlockwise

  /// Here, of what is bilinear between the corners.
  [[nodiscard]] static double mix(double s, double t, const std::array<double, 4>& at) {
    return (1 - t) * ((1 - s) * at[0] + s * at[1]) + t * ((1 - s) * at[3] + s * at[2]);
  }
  [[nodiscard]] double mix(const std::array<double, 4>& at) const { return mix(s, t, at); }
};

/// Calls visit(point) for each point of the rule that has an area; their sum is the quadrilateral's. Polynomials of
/// degree 2 are integrated exactly over parallelograms.
template <class Visit>
void each_swept_point(const std::array<Point, 4>& at, const Visit& visit) {
  constexpr double gauss = 0.5 / std::numbers::sqrt3;
  const std::array x{at[0].x, at[1].x, at[2].x, at[3].x};
  const std::array y{at[0].y, at[1].y, at[2].y, at[3].y};
  for (const double s : {0.5 - gauss, 0.5 + gauss}) {
    for (const double t : {0.5 - gauss, 0.5 + gauss}) {
      const auto by_s = [t](const std::array<double, 4>& a) { return (1 - t) * (a[1] - a[0]) + t * (a[2] - a[3]); };
      const auto by_t = [s](const std::array<double, 4>& a) { return (1 - s) * (a[3] - a[0]) + s * (a[2] - a[1]); };
      const double area = 0.25 * (by_s(x) * by_t(y) - by_s(y) * by_t(x));
      if (area == 0) continue;
      visit(SweptPoint{.s = s, .t = t, .place = {SweptPoint::mix(s, t, x), SweptPoint::mix(s, t, y)}, .area = area});
    }
  }
}

}  // namespace seiche
