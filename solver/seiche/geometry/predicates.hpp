/// Signs that are right for every input: on which side of a line, inside or outside a circle.
///
/// Evaluated in double precision; where the error bound of that does not settle the sign, in whole numbers of
/// Boost.Multiprecision, about a microsecond. A mesh that is decided upon with them cannot contradict itself. Right
/// unless a product of four coordinates under- or overflows.
///
/// Reference: Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, Discrete
/// Comput. Geom. 18 (1997) 305.
#pragma once

#include <cmath>

#include "seiche/geometry/curve.hpp"

namespace seiche {

namespace exactly {
double orientation(Point a, Point b, Point c);
double in_circle(Point a, Point b, Point c, Point d);
}  // namespace exactly

/// Twice the area of the triangle abc: positive when it is counter-clockwise, zero exactly when the points are on one
/// line.
inline double orientation(Point a, Point b, Point c) {
  constexpr double bound = 3.3306690738754716e-16;  // (3 + 16 u) u, u = 2^-53
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double area = left - right;
  if (std::abs(area) > bound * (std::abs(left) + std::abs(right))) return area;
  return exactly::orientation(a, b, c);
}

/// Positive when d is inside the circle through a, b, c, which are counter-clockwise; zero exactly when it is on it.
inline double in_circle(Point a, Point b, Point c, Point d) {
  constexpr double bound = 1.1102230246251577e-15;  // (10 + 96 u) u
  const double ax = a.x - d.x;
  const double ay = a.y - d.y;
  const double bx = b.x - d.x;
  const double by = b.y - d.y;
  const double cx = c.x - d.x;
  const double cy = c.y - d.y;
  const double a2 = ax * ax + ay * ay;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double bc = bx * cy;
  const double cb = cx * by;
  const double ca = cx * ay;
  const double ac = ax * cy;
  const double ab = ax * by;
  const double ba = bx * ay;
  const double inside = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
  const double terms =
      a2 * (std::abs(bc) + std::abs(cb)) + b2 * (std::abs(ca) + std::abs(ac)) + c2 * (std::abs(ab) + std::abs(ba));
  if (std::abs(inside) > bound * terms) return inside;
  return exactly::in_circle(a, b, c, d);
}

}  // namespace seiche
