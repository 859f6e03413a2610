#include "seiche/geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

namespace seiche::exactly {

namespace {

using Integer = boost::multiprecision::cpp_int;

/// Points as whole multiples of one power of two.
template <std::size_t Points>
class Whole {
 public:
  struct Vector {
    Integer x, y;
  };

  explicit Whole(const std::array<Point, Points>& points) {
    for (const Point& p : points) {
      finite_ = finite_ && std::isfinite(p.x) && std::isfinite(p.y);
      for (const double c : {p.x, p.y}) {
        if (c != 0) unit_ = std::min(unit_, std::ilogb(c) - 52);
      }
    }
    for (std::size_t k = 0; finite_ && k < Points; ++k) points_[k] = {times_unit(points[k].x), times_unit(points[k].y)};
  }
  /// From the last point to the k-th.
  [[nodiscard]] Vector vector(std::size_t k) const {
    const auto& [x, y] = points_[Points - 1];
    return {points_[k].x - x, points_[k].y - y};
  }
  /// A sum of products of so many coordinates. NaN where the points were not finite.
  [[nodiscard]] double value(const Integer& sum, int coordinates) const {
    if (!finite_) return std::numeric_limits<double>::quiet_NaN();
    // As many digits as a double has: the rest would not fit its range.
    const int beyond = sum == 0 ? 0 : std::max(0, static_cast<int>(msb(abs(sum))) - 60);
    return std::ldexp(static_cast<double>(Integer(sum / (Integer(1) << beyond))), beyond + coordinates * unit_);
  }

 private:
  [[nodiscard]] Integer times_unit(double c) const {
    const int shift = c == 0 ? 0 : std::ilogb(c) - 52;
    return Integer(static_cast<long long>(std::ldexp(c, -shift))) * (Integer(1) << (c == 0 ? 0 : shift - unit_));
  }

  bool finite_ = true;
  int unit_ = 1024;
  std::array<Vector, Points> points_;
};

template <class Vector>
Integer cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}
template <class Vector>
Integer square(const Vector& a) {
  return a.x * a.x + a.y * a.y;
}

}  // namespace

double orientation(Point a, Point b, Point c) {
  const Whole<3> whole({a, b, c});
  return whole.value(cross(whole.vector(0), whole.vector(1)), 2);
}

double in_circle(Point a, Point b, Point c, Point d) {
  const Whole<4> whole({a, b, c, d});
  const auto da = whole.vector(0), db = whole.vector(1), dc = whole.vector(2);
  return whole.value(square(da) * cross(db, dc) + square(db) * cross(dc, da) + square(dc) * cross(da, db), 4);
}

}  // namespace seiche::exactly
