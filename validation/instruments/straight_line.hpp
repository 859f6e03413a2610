/// Least-squares line v = mean_v + slope (u - mean_u) with the standard errors that its residuals give.
#pragma once

#include <span>

#include "reports/evidence/claim.hpp"

namespace seiche::validation {

struct StraightLine {
  double mean_u = 0;
  double mean_v = 0;
  double slope = 0;
  double mean_error = 0;   ///< standard error of mean_v
  double slope_error = 0;  ///< standard error of the slope
  std::size_t points = 0;

  [[nodiscard]] double at(double u) const { return mean_v + slope * (u - mean_u); }
  /// Where the line reaches v; uncertainty: twice the standard error that those of the line give.
  [[nodiscard]] evidence::Measurement where(double v) const;
  /// arctan |slope| and twice its standard error [rad].
  [[nodiscard]] evidence::Measurement angle() const;
};

/// Two points leave no residuals and give errors of 0. Throws std::invalid_argument for fewer than two different u.
StraightLine straight_line(std::span<const double> u, std::span<const double> v);

/// The same with the slope's error widened by half the difference of the slopes of the two halves of the points: what
/// bends slowly has small and dependent residuals. Points in the order of u; at least 4.
StraightLine straight_line_of_curve(std::span<const double> u, std::span<const double> v);

}  // namespace seiche::validation
