/// The trigonometric polynomial through samples of a periodic function, and points at equal arc length along a curve.
///
/// Shape of a marked surface between its markers: extremes, the jet of an overturning crest, points at equal arc
/// length.
///
/// Distance of periodic curves: how far apart two surfaces are, whatever their parameters.
///
/// A curve is given by points z_j at equal steps of a smooth parameter over one period, along which x grows by the
/// period. In between it is its trigonometric interpolant, replaced on a refined grid by cubics with its tangents.
///
/// When not to use it: points with corners, or unequal steps of a parameter that is not smooth.
#pragma once

#include <cmath>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "seiche/exact/overturning/surface_velocity.hpp"
#include "seiche/exact/reference_solution.hpp"

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

class SurfaceCurve {
 public:
  explicit SurfaceCurve(SurfaceView<const double> surface);

  /// Point x + iy at label s.
  [[nodiscard]] std::complex<double> point(double s) const { return periodic_(s) + s; }
  /// Smallest x_s: zero when the surface first has a vertical tangent, negative where it overhangs.
  [[nodiscard]] double least_advance() const;
  /// Largest magnitude of the curvature.
  [[nodiscard]] double largest_curvature() const;
  [[nodiscard]] double highest() const;
  [[nodiscard]] double lowest() const;

  /// An overhang: x decreases along the surface from the nose of the jet to the throat of the cavity below it.
  struct Overhang {
    std::complex<double> nose;
    std::complex<double> throat;
    double gap = 0;  ///< least distance of the outer half of the jet from the water ahead
  };
  /// The widest one; none before the first vertical tangent.
  [[nodiscard]] std::optional<Overhang> overhang() const;

  [[nodiscard]] std::vector<double> labels_at_equal_arc_length(std::size_t points) const {
    return overturning::labels_at_equal_arc_length(tangents_, points);
  }

 private:
  [[nodiscard]] std::complex<double> node(std::size_t i) const;
  [[nodiscard]] double label_of_vertical_tangent(std::size_t i) const;
  [[nodiscard]] double gap(std::size_t nose, std::size_t throat) const;

  TrigonometricInterpolant periodic_;
  std::vector<std::complex<double>> nodes_;     ///< z - s at 16 labels per marker
  std::vector<std::complex<double>> tangents_;  ///< z_s there
};

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
