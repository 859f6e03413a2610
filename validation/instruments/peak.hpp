/// The first high point of a series that comes value by value, between its points.
#pragma once

#include <limits>

namespace seiche::validation {

/// Keeps the highest value of a series and its neighbours; between them runs the parabola through the three.
class Peak {
 public:
  /// @param t  increasing
  void add(double t, double value);

  /// Top of the parabola; the highest value itself while it is the first or the last.
  /// NaN if a value was, or if there was none.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double time() const { return time_; }

 private:
  struct Point {
    double t = 0;
    double value = 0;
  };
  void refine(Point after);

  Point before_;
  Point highest_;
  Point last_;
  long count_ = 0;
  bool highest_is_last_ = false;
  double value_ = std::numeric_limits<double>::quiet_NaN();
  double time_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace seiche::validation
