/// The trigonometric polynomial through samples of a periodic function, and points at equal arc length along a curve.
///
/// Shape of a surface between the points that mark it: extremes, the jet of an overturning crest, points at equal arc
/// length, and its distance from another, whatever their parameters. Lengths are those in which the period is 2 pi.
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

class SurfaceCurve {
 public:
  /// @param displacements  z_j - s_j, periodic, at the labels s_j = 2 pi j/N of at least 8 points of the surface
  explicit SurfaceCurve(std::span<const std::complex<double>> displacements);

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

  /// Labels of points at equal arc length, the first at s = 0, the last at s = 2 pi.
  [[nodiscard]] std::vector<double> labels_at_equal_arc_length(std::size_t points) const;

  /// From a point to the nearest point of the curve or of its periodic images.
  [[nodiscard]] double distance(std::complex<double> place) const;
  /// Largest distance of a point of either curve from the other, over every fourth node: symmetric Hausdorff distance.
  [[nodiscard]] double distance(const SurfaceCurve& other) const;

 private:
  [[nodiscard]] std::complex<double> node(std::size_t i) const;
  [[nodiscard]] double label_of_vertical_tangent(std::size_t i) const;
  [[nodiscard]] double gap(std::size_t nose, std::size_t throat) const;

  TrigonometricInterpolant periodic_;           ///< z - s
  TrigonometricInterpolant tangent_;            ///< z_s - 1
  std::vector<std::complex<double>> nodes_;     ///< z - s at 16 labels per marker
  std::vector<std::complex<double>> tangents_;  ///< z_s there
};

}  // namespace seiche::exact::overturning
