/// Curves in the vertical plane along which nodes slide, by their arc length s: positions, unit tangents, and the
/// moment
///
///     W(s) = int_0^s (y^2/2) x' ds,
///
/// which enters the potential energy of water that ends at the curve.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "seiche/divergence.hpp"

namespace seiche {

/// A point or a vector in the vertical plane: x horizontal, y upwards.
struct Point {
  double x = 0;
  double y = 0;
};

inline Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double a, Point b) {
  return {a * b.x, a * b.y};
}
inline Point& operator+=(Point& a, Point b) {
  return a = a + b;
}
inline double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
inline double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

class Curve {
 public:
  virtual ~Curve() = default;
  /// Throw Infeasible beyond the ends.
  [[nodiscard]] virtual Point position(double s) const = 0;
  [[nodiscard]] virtual Point tangent(double s) const = 0;
  /// d tangent/ds.
  [[nodiscard]] virtual Point curvature(double s) const = 0;
  /// Chord (r(s1) - r(s0))/(s1 - s0), without cancellation: the tangent for s0 = s1.
  [[nodiscard]] virtual Point mean_tangent(double s0, double s1) const = 0;
  [[nodiscard]] virtual double moment(double s) const = 0;
  /// (W(s1) - W(s0))/(s1 - s0), without cancellation.
  [[nodiscard]] virtual double mean_moment_rate(double s0, double s1) const = 0;
  /// Arc length of the point of the curve next to a point near it.
  [[nodiscard]] virtual double arc_length_at(Point near) const = 0;
};

/// Straight line without ends.
class Line final : public Curve {
 public:
  /// @param direction  of any length but zero. Throws std::invalid_argument.
  Line(Point origin, Point direction);
  [[nodiscard]] Point position(double s) const override { return origin_ + s * tangent_; }
  [[nodiscard]] Point tangent(double) const override { return tangent_; }
  [[nodiscard]] Point curvature(double) const override { return {0, 0}; }
  [[nodiscard]] Point mean_tangent(double, double) const override { return tangent_; }
  [[nodiscard]] double moment(double s) const override { return s * mean_moment_rate(0, s); }
  [[nodiscard]] double mean_moment_rate(double s0, double s1) const override;
  [[nodiscard]] double arc_length_at(Point near) const override { return dot(near - origin_, tangent_); }

 private:
  Point origin_, tangent_;
};

/// Graph y = b(x) over [begin, end], b twice differentiable. Arc lengths by Gauss quadrature over panels, places by
/// Newton's iteration inside a panel: both to round-off if b is smooth over a panel.
class GraphCurve final : public Curve {
 public:
  using Function = std::function<double(double)>;

  /// @param panels  of equal width; s = 0 at `begin`. Throws std::invalid_argument for missing functions, an empty
  ///                interval, no panels, or values that are not finite.
  GraphCurve(Function elevation, Function slope, Function second_derivative, double begin, double end,
             std::size_t panels);
  [[nodiscard]] Point position(double s) const override;
  [[nodiscard]] Point tangent(double s) const override;
  [[nodiscard]] Point curvature(double s) const override;
  [[nodiscard]] Point mean_tangent(double s0, double s1) const override;
  [[nodiscard]] double moment(double s) const override;
  [[nodiscard]] double mean_moment_rate(double s0, double s1) const override;
  [[nodiscard]] double arc_length_at(Point near) const override;
  [[nodiscard]] double length() const { return knots_.back(); }

 private:
  [[nodiscard]] double place(double s) const;
  // Means over places, from which all integrals follow.
  [[nodiscard]] double mean_stretch(double from, double to) const;
  [[nodiscard]] double mean_moment(double from, double to) const;
  [[nodiscard]] std::size_t panel(double x) const;
  [[nodiscard]] double panel_begin(std::size_t k) const { return begin_ + width_ * static_cast<double>(k); }

  Function elevation_, slope_, second_derivative_;
  double begin_, end_, width_;
  std::vector<double> knots_;    // arc length at the panels' ends
  std::vector<double> moments_;  // W there
};

// Two straight lines that meet at a corner rounded by an arc of a circle, without ends: a level bottom and the slope
// that rises from it.
//
// Arc lengths s count from the middle of the arc. All in closed form but the moment over the arc, which is a Gauss
// quadrature to round-off.

class BentLine final : public Curve {
 public:
  /// @param corner  where the lines would meet;  @param before, after  directions of the lines, of any length but zero
  /// @param rounding  length of either line that the arc replaces
  /// Throws std::invalid_argument: values that are not finite, no rounding, lines that do not turn, or by a right angle
  /// or more.
  BentLine(Point corner, Point before, Point after, double rounding);
  [[nodiscard]] Point position(double s) const override;
  [[nodiscard]] Point tangent(double s) const override;
  [[nodiscard]] Point curvature(double s) const override;
  [[nodiscard]] Point mean_tangent(double s0, double s1) const override;
  [[nodiscard]] double moment(double s) const override { return s * mean_moment_rate(0, s); }
  [[nodiscard]] double mean_moment_rate(double s0, double s1) const override;
  [[nodiscard]] double arc_length_at(Point near) const override;
  [[nodiscard]] double radius() const { return radius_; }

 private:
  /// Mean over [s0, s1], in either order, from the means over what of it lies before, on and after the arc.
  template <class Value, class Before, class Arc, class After>
  [[nodiscard]] Value mean(double s0, double s1, const Before& before, const Arc& arc, const After& after) const;

  double radius_, half_, bend_;  ///< of the arc: half its length, its curvature with sign
  Line before_, after_;          ///< their arc lengths are the curve's
};

}  // namespace seiche
