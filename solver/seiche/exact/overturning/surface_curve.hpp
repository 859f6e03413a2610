/// The trigonometric polynomial through samples of a periodic function, and points at equal arc length along a curve.
///
/// Shape of a surface between the points that mark it: extremes, the jet of an overturning crest, points at equal arc
/// length, and its distance from another, whatever their parameters. Lengths are those in which the period is 2 pi.
///
/// When not to use it: points with corners, or unequal steps of a parameter that is not smooth.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
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

// The computed motion of a free surface in the units of its user, from its start to its end: what every wave that may
// overturn can be asked.
//
// Lengths are scaled by 1/k (k = 2 pi/wavelength), times by 1/sqrt(g k).
//
// When not to use it: after touch-down.

class Evolution;

class MovingSurface {
 public:
  /// Points of the surface along one wavelength, in the order of the surface, with potential [m^2/s] and velocity
  /// [m/s].
  struct Profile {
    double time = 0;
    std::vector<double> x, y, potential, u, v;
  };
  /// At the markers or, where `points` is not 0, at so many points of equal arc length of the trigonometric
  /// interpolant, the first and last one wavelength apart. Throws std::invalid_argument for a time before 0 or after
  /// last_time, Divergence for one after the motion ended.
  [[nodiscard]] Profile profile(double t, std::size_t points = 0) const;

  /// Highest and lowest elevation [m].
  struct Extremes {
    double highest, lowest;
  };
  [[nodiscard]] Extremes extremes(double t) const;

  /// Largest magnitude of the surface's curvature [1/m].
  [[nodiscard]] double largest_curvature(double t) const;

  /// Nose of the jet and throat of the cavity below it, where the surface is vertical [m], and the least distance
  /// between the outer half of the jet and the water ahead [m]; none while the surface is a graph.
  struct Jet {
    double nose_x, nose_y, throat_x, throat_y, gap;
  };
  [[nodiscard]] std::optional<Jet> jet(double t) const;

  /// First time with a vertical tangent [s]; none if not before end_time().
  [[nodiscard]] std::optional<double> vertical_tangent_time() const { return vertical_tangent_time_; }
  /// When the gap closes [s]: extrapolated linearly from its last values that the markers resolve, less than a
  /// twentieth of a wavelength apart; none if the gap is not that small in the computed motion.
  [[nodiscard]] std::optional<double> touch_down_time() const { return touch_down_time_; }
  /// Last time computed [s]: last_time, or when the time step or the resolution collapsed.
  [[nodiscard]] double end_time() const;
  /// Why the motion ended before last_time; empty if it did not.
  [[nodiscard]] std::string ending_reason() const;
  [[nodiscard]] std::size_t steps() const;

  /// Per wavelength, for density 1: volume above the level at rest [m^2], kinetic and potential energy [m^4/s^2],
  /// horizontal impulse [m^3/s].
  struct Integrals {
    double volume, kinetic_energy, potential_energy, impulse;
  };
  [[nodiscard]] Integrals integrals(double t) const;

  /// Until when a jet, if there is one, is developed and not yet thin [s].
  [[nodiscard]] double well_resolved_until() const { return well_resolved_until_; }
  /// Hausdorff distance of the surface from that of another motion of the same wavelength [m].
  [[nodiscard]] double distance_from(const MovingSurface& other, double t) const;

  /// Distance of the surface from a second computation with three quarters of the markers and ten times the tolerance,
  /// relative to the amplitude and the head of a pressure; at the time well_resolved_until(), if none is given. Takes
  /// as long as that computation.
  [[nodiscard]] double uncertainty() const { return uncertainty(well_resolved_until()); }
  [[nodiscard]] double uncertainty(double t) const { return distance_from(coarser_(t), t) / scale_; }

 protected:
  using Computation = std::function<MovingSurface(double last_time)>;
  /// @param scale  of elevations [m];  @param coarser  the second computation
  MovingSurface(double wavelength, double gravity, double scale, Computation coarser);

  /// Computes a motion from its start in scaled units. @param last_time  until then [s]
  /// @param jet_time  for how long after the first vertical tangent the surface is well resolved, from the time of that
  ///                  tangent [s];  @param kink  scaled time at which a pressure is not smooth
  void compute(Evolution motion, double last_time, const std::function<double(double tangent)>& jet_time,
               double kink = 0);

  [[nodiscard]] const Evolution& evolution() const { return *evolution_; }
  [[nodiscard]] double length() const { return length_; }      ///< 1/k [m]
  [[nodiscard]] double time_unit() const { return time_; }     ///< 1/sqrt(g k) [s]
  [[nodiscard]] double velocity() const { return velocity_; }  ///< sqrt(g/k) [m/s]
  /// Identities of any motion up to well_resolved_until(): volume is conserved, energy and horizontal impulse change by
  /// what a pressure on the surface does, if there is one.
  ///
  /// @param amplitude  of the surface [m];  @param tolerance  of a step, in units of 1/k;  @param first  of the start
  [[nodiscard]] SelfTest balances(double amplitude, double tolerance, const std::optional<Identity>& first) const;
  [[nodiscard]] double scale() const { return scale_; }
  /// A time between 0 and the end, scaled. Throws as profile does.
  [[nodiscard]] double scaled_time(double t) const;

 private:
  void find_touch_down();

  double length_, time_, velocity_, scale_;
  Computation coarser_;
  double last_time_ = 0;
  double well_resolved_until_ = 0;
  std::shared_ptr<const Evolution> evolution_;
  std::optional<double> vertical_tangent_time_;
  std::optional<double> touch_down_time_;
};

}  // namespace seiche::exact::overturning
