/// Distance of periodic curves: how far apart two surfaces are, whatever their parameters.
///
/// A curve is given by points z_j at equal steps of a smooth parameter over one period, along which x grows by the
/// period. In between it is its trigonometric interpolant, replaced on a refined grid by cubics with its tangents.
///
/// When not to use it: points with corners, or unequal steps of a parameter that is not smooth.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace seiche::exact::overturning {

class PeriodicCurve {
 public:
  /// @param points      one period without the repeated end point, at least 8
  /// @param refinement  nodes per point
  explicit PeriodicCurve(std::span<const std::complex<double>> points, double period, std::size_t refinement = 16);

  /// From a point to the nearest point of the curve or of its periodic images.
  [[nodiscard]] double distance(std::complex<double> point) const;
  [[nodiscard]] std::span<const std::complex<double>> nodes() const { return nodes_; }
  [[nodiscard]] double period() const { return period_; }

 private:
  std::vector<std::complex<double>> nodes_;
  std::vector<std::complex<double>> tangents_;  ///< per node spacing
  double period_;
};

/// Largest distance of a point of either curve from the other, over every `stride`-th node: symmetric Hausdorff
/// distance.
double hausdorff_distance(const PeriodicCurve& a, const PeriodicCurve& b, std::size_t stride = 4);

}  // namespace seiche::exact::overturning
