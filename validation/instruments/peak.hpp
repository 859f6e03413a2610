/// The first high point of a series that comes value by value, between its points.
#pragma once

namespace seiche::validation {

/// Keeps the highest value of a series and its neighbours; between them runs the parabola through the three.
class Peak {
 public:
  /// @param t  increasing
  void add(double t, double value);

  /// Top of the parabola; the highest value itself while it is the first or the last.
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
  double value_ = 0;
  double time_ = 0;
};

}  // namespace seiche::validation
