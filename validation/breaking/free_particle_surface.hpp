/// The surface of a breaking wave of free particles: the line of its markers, or the outline of its water. The waves
/// are periodic, of length 2 pi.
#pragma once

#include <vector>

#include "seiche/models/gauss_particles/flow.hpp"
#include "validation/instruments/polyline_distance.hpp"

namespace seiche::validation {

/// The line of the markers and, once more, its first one a wavelength on.
Polyline marker_line(const gauss_particles::Flow& flow);

/// Whether the front of the line is past the vertical.
bool goes_backwards(const std::vector<Point>& line);

/// The outline of the particles' water over one wavelength, without what closes it along the bottom.
/// @param spacing  of the particles;  @param below  level between the bottom and the deepest trough
Polylines water_outline(const gauss_particles::Flow& flow, double spacing, double below);

/// By how much water sticks out of the discs of this diameter that fit into it. @param surface  one wavelength, 2 pi
double thin_part(const Polyline& surface, double diameter);

}  // namespace seiche::validation
