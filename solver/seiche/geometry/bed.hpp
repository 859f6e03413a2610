#pragma once

#include <functional>

namespace seiche {

/// Bed elevation z(x) [m] with its primitive Z(x), Z' = z [m^2]: models that keep a lake at rest to round-off need the
/// exact mean of the bed over a cell, not a sample of it.
struct Bed {
  std::function<double(double)> elevation;
  std::function<double(double)> primitive;

  /// Throws std::invalid_argument unless both functions are given, finite and consistent: at sampled points of
  /// [start, end] a central difference of the primitive must agree with the elevation to 1e-6 of the range of the
  /// elevations and 0.
  void validate(double start, double end) const;
};

/// Bed z = 0.
Bed flat_bed();

}  // namespace seiche
