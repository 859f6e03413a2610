/// What an edge sweeps on its way from one place to another: the quadrilateral of its old and new ends, by Gauss's rule
/// of 2 x 2 points.
#pragma once

#include <array>
#include <numbers>

#include "seiche/geometry/curve.hpp"

namespace seiche {

/// Calls visit(place, area) for each point of the rule. The areas are signed, positive for corners that go around
/// anticlockwise, and their sum is the quadrilateral's; points without area are left out. Polynomials of degree 2 are
/// integrated exactly over parallelograms.
template <class Visit>
void each_swept_point(const std::array<Point, 4>& at, const Visit& visit) {
  constexpr double gauss = 0.5 / std::numbers::sqrt3;
  const auto x = [](Point a) { return a.x; };
  const auto y = [](Point a) { return a.y; };
  for (const double s : {0.5 - gauss, 0.5 + gauss}) {
    for (const double t : {0.5 - gauss, 0.5 + gauss}) {
      const auto mix = [&](auto part) {
        return (1 - t) * ((1 - s) * part(at[0]) + s * part(at[1])) + t * ((1 - s) * part(at[3]) + s * part(at[2]));
      };
      const auto by_s = [&](auto part) {
        return (1 - t) * (part(at[1]) - part(at[0])) + t * (part(at[2]) - part(at[3]));
      };
      const auto by_t = [&](auto part) {
        return (1 - s) * (part(at[3]) - part(at[0])) + s * (part(at[2]) - part(at[1]));
      };
      const double area = 0.25 * (by_s(x) * by_t(y) - by_s(y) * by_t(x));
      if (area != 0) visit(Point{mix(x), mix(y)}, area);
    }
  }
}

}  // namespace seiche
