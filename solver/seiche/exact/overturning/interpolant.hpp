/// The trigonometric polynomial through samples of a periodic function, and points at equal arc length along a curve.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace seiche::exact::overturning {

class TrigonometricInterpolant {
 public:
  /// Samples at s_j = 2 pi j/N.
  explicit TrigonometricInterpolant(std::span<const std::complex<double>> samples);

  [[nodiscard]] std::complex<double> operator()(double s) const;
  /// Derivative with respect to s.
  [[nodiscard]] TrigonometricInterpolant derivative() const;
  /// Values at refinement N equally spaced labels, s = 0 first.
  [[nodiscard]] std::vector<std::complex<double>> refined(std::size_t refinement) const;

 private:
  TrigonometricInterpolant() = default;

  std::vector<std::complex<double>> coefficients_;  ///< of exp(iks), k = -(N-1)/2 .. N/2
  long lowest_ = 0;
};

/// Labels of points at equal arc length, the first at s = 0, the last at s = 2 pi.
///
/// @param tangent  z_s at equally spaced labels, s = 0 first, enough of them to resolve |z_s|
std::vector<double> labels_at_equal_arc_length(std::span<const std::complex<double>> tangent, std::size_t points);

}  // namespace seiche::exact::overturning
