/// Shape of a marked surface between its markers: extremes, the jet of an overturning crest, points at equal arc
/// length.
#pragma once

#include <optional>

#include "seiche/exact/overturning/interpolant.hpp"
#include "seiche/exact/overturning/surface.hpp"

namespace seiche::exact::overturning {

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

}  // namespace seiche::exact::overturning
