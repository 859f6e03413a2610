/// How far apart two curves are that need not be graphs: overturning surfaces, contours of particles.
///
/// The distance of a point is that to the nearest segment of the other curve. rms is sqrt of the mean of both mean
/// squares, each taken over one curve's arc length; largest is Hausdorff's distance over the middles of the segments.
///
/// When not to use it: curves whose correspondence matters (a shifted sawtooth is near to itself everywhere).
#pragma once

#include <vector>

namespace seiche::validation {

/// Pieces of a curve, each a chain of points joined by straight lines.
struct Polyline {
  std::vector<double> x, y;
};
using Polylines = std::vector<Polyline>;

struct PolylineDistance {
  double rms = 0;
  double largest = 0;
};

/// @param period  of both curves along x: images one period to the left and right are looked at too; 0: none
/// Throws std::invalid_argument for curves without a segment.
PolylineDistance polyline_distance(const Polylines& a, const Polylines& b, double period = 0);

}  // namespace seiche::validation
