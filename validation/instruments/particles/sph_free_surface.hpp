/// Free surface of a set of particles as curves: where the volume fraction is 1/2. And what waves do before and as they
/// break, read off these curves.
///
///     const VolumeFraction fraction(flow.particles(), flow.smoothing_length(), {.left = 0, .right = 4 * a, ...});
///     const std::vector<Contour> curves = free_surface(fraction, box, flow.spacing() / 2);
///     const Contour* surface = main_surface(curves);
///     if (surface && overhang(*surface).extent > flow.spacing()) ...  // the front is past the vertical
///
/// Curves have the water on their right: a level surface runs towards +x, a closed curve around air counter-clockwise.
///
/// When not to use it: along walls of dynamic particles a gap of about a spacing stays open and would show as air. A
/// box that ends a spacing in front of them leaves it out.
///
/// Reference for the extraction: Lorensen and Cline, Marching cubes, Computer Graphics 21 (1987) 163, in the plane,
/// with ambiguous cells decided by the mean of their corners.
#pragma once

#include <vector>

#include "validation/instruments/particles/sph_volume_fraction.hpp"

namespace seiche::wcsph {

/// An ordered polyline; a closed one does not repeat its first point.
struct Contour {
  std::vector<double> x, z;
  bool closed = false;
  /// Area of air that the curve, alone or with the sides and the lower end of the box, shuts off from above [m^2].
  double air = 0;

  /// Enclosed area, positive around air, negative around water [m^2]; 0 for an open curve.
  [[nodiscard]] double area() const;
  [[nodiscard]] Place centroid() const;  ///< of the enclosed area
  [[nodiscard]] double length() const;
  /// Distance of a point to the polyline [m].
  [[nodiscard]] double distance(double px, double pz) const;
};

/// Values at the points (left + i step, bottom + j step), i fastest.
struct Raster {
  double left = 0;
  double bottom = 0;
  double step = 0;
  long columns = 0;
  long rows = 0;
  std::vector<double> values;
};

/// Curves where the value is `level`, the longest first; what is at or above it is water.
std::vector<Contour> level_curves(const Raster& raster, double level);

/// Curves of fraction 1/2 in a box, on a grid of about `step` (dx/2 resolves what particles do). In a periodic box any
/// window of one period will do; one that begins in a trough cuts no cavity.
std::vector<Contour> free_surface(const VolumeFraction& fraction, const Box& box, double step);

/// The longest open curve, or the longest at all; nullptr if there is none.
const Contour* main_surface(const std::vector<Contour>& curves);

/// Where a surface hangs over itself.
struct Overhang {
  double extent = 0;          ///< largest decrease of x along the curve [m]; 0 while the surface is single-valued
  Place tip{};                ///< of the jet: where the overhanging part reaches farthest forward
  bool towards_right = true;  ///< the wave breaks towards +x
};
Overhang overhang(const Contour& surface);

/// The surface is not single-valued in x any more: it hangs over by more than `least` (dx is safe against noise).
bool overturns(const std::vector<Contour>& curves, double least);
/// The jet has closed a cavity: there is air enclosed, with an area above `least` (4 dx^2 is a hole that is not noise).
bool touches_down(const std::vector<Contour>& curves, double least);
/// Area of all the air that is enclosed, in cavities larger than `least` [m^2].
double cavity_area(const std::vector<Contour>& curves, double least);

}  // namespace seiche::wcsph
