/// What an edge sweeps on its way from one place to another: the quadrilateral of its old and new ends, by Gauss's rule
/// of 2 x 2 points.
#pragma once

#include <array>
#include <numbers>

#include "seiche/geometry/bilinear_patch.hpp"
#include "seiche/geometry/curve.hpp"

namespace seiche {

/// A point of the rule.
struct SweptPoint {
  double s, t;  ///< in the quadrilateral: s from corner 0 to 1, t from corner 0 to 3
  Point place;
  double area;  ///< its part, with the sign of corners that go around anticlockwise
};

/// Calls visit(point) for each point of the rule that has an area; their sum is the quadrilateral's. Polynomials of
/// degree 2 are integrated exactly over parallelograms.
template <class Visit>
void each_swept_point(const std::array<Point, 4>& at, const Visit& visit) {
  constexpr double gauss = 0.5 / std::numbers::sqrt3;
  using namespace bilinear_patch;
  const Corners x{at[0].x, at[1].x, at[2].x, at[3].x};
  const Corners y{at[0].y, at[1].y, at[2].y, at[3].y};
  for (const double s : {0.5 - gauss, 0.5 + gauss}) {
    for (const double t : {0.5 - gauss, 0.5 + gauss}) {
      const double area = 0.25 * (along_s(x, t) * along_t(y, s) - along_s(y, t) * along_t(x, s));
      if (area == 0) continue;
      visit(SweptPoint{.s = s, .t = t, .place = {mix(x, s, t), mix(y, s, t)}, .area = area});
    }
  }
}

}  // namespace seiche
