/// The first high point of a series that comes value by value, between its points.
#pragma once

#include <cmath>
#include <limits>

namespace seiche::validation {

/// Keeps the highest value of a series and its neighbours; between them runs the parabola through the three.
class Peak {
 public:
  /// @param t  increasing
  void add(double t, double value) {
    const Point now{t, value};
    if (count_ > 0 && std::isnan(value_)) return;
    if (std::isnan(value)) {
      value_ = value;
      time_ = t;
    } else if (count_ == 0 || value > highest_.value) {
      before_ = count_ == 0 ? now : last_;
      highest_ = now;
      time_ = t;
      value_ = value;
      highest_is_last_ = true;
    } else if (highest_is_last_) {
      if (before_.t < highest_.t) refine(now);
      highest_is_last_ = false;
    }
    last_ = now;
    ++count_;
  }

  /// Top of the parabola; the highest value itself while it is the first or the last.
  /// NaN if a value was, or if there was none.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double time() const { return time_; }

 private:
  struct Point {
    double t = 0;
    double value = 0;
  };
  void refine(Point after) {
    const double left = before_.t - highest_.t;
    const double right = after.t - highest_.t;
    const double slope_left = (before_.value - highest_.value) / left;
    const double slope_right = (after.value - highest_.value) / right;
    const double curvature = (slope_right - slope_left) / (right - left);
    if (!(curvature < 0)) return;
    const double slope = slope_left - curvature * left;  // of the parabola at its middle point
    const double shift = -slope / (2 * curvature);
    time_ = highest_.t + shift;
    value_ = highest_.value + 0.5 * slope * shift;
  }

  Point before_;
  Point highest_;
  Point last_;
  long count_ = 0;
  bool highest_is_last_ = false;
  double value_ = std::numeric_limits<double>::quiet_NaN();
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace seiche::validation
