/// Two straight lines that meet at a corner rounded by an arc of a circle, without ends: a level bottom and the slope
/// that rises from it.
///
/// Arc lengths s count from the middle of the arc. All in closed form but the moment over the arc, which is a Gauss
/// quadrature to round-off.
#pragma once

#include "seiche/geometry/curve.hpp"

namespace seiche {

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
  [[nodiscard]] double moment(double s) const override;
  [[nodiscard]] double mean_moment_rate(double s0, double s1) const override;
  [[nodiscard]] double arc_length_at(Point near) const override;
  [[nodiscard]] double radius() const { return radius_; }

 private:
  [[nodiscard]] double mean_moment_on_arc(double s0, double s1) const;
  /// Mean over [s0, s1], in either order, from the means over what of it lies before, on and after the arc.
  template <class Value, class Before, class Arc, class After>
  [[nodiscard]] Value mean(double s0, double s1, const Before& before, const Arc& arc, const After& after) const;

  double radius_, half_, bend_;  ///< of the arc: half its length, its curvature with sign
  Line before_, after_;          ///< their arc lengths are the curve's
};

}  // namespace seiche
