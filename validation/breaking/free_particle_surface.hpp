/// The surface of a breaking wave of free particles: the line of its markers, or the outline of its water. The waves
/// are periodic, of length 2 pi.
#pragma once

#include <functional>
#include <vector>

#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/models/gauss_particles/flow.hpp"
#include "validation/instruments/polyline_distance.hpp"

namespace seiche::validation {

/// A wave of particles at its start, in units of 1/k, g and the density.
struct ParticleWave {
  double depth = 0;
  long cells = 0;  ///< to the wavelength
  long side = 0;   ///< particles to a cell's
  std::size_t rows = 0, markers = 0;
  std::function<double(double x)> surface = {};

  /// On splines whose square cells are shifted at random, with the usual penalty.
  [[nodiscard]] gauss_particles::Flow start(const mechanics::VelocityAt& velocity,
                                            gauss_particles::Forcing forcing = {}) const;
};

/// One wavelength of an exact surface.
Polyline exact_wave(const exact::overturning::MovingSurface& exact, double time);
/// The points as a line.
Polyline line_through(const std::vector<Point>& points);
/// The line of the markers and, once more, its first one a wavelength on.
Polyline marker_line(const gauss_particles::Flow& flow);

/// Whether the front of the line is past the vertical.
bool goes_backwards(const std::vector<Point>& line);

/// The outline of the particles' water over one wavelength, without what closes it along the bottom.
/// @param spacing  of the particles;  @param below  level between the bottom and the deepest trough
Polylines water_outline(const gauss_particles::Flow& flow, double spacing, double below);

/// By how much water sticks out of the discs of this diameter that fit into it. @param surface  one wavelength, 2 pi
double thin_part(const Polyline& surface, double diameter);
/// How far the particles' surface may be from the exact one: what a curve bends within a cell, half a cell at most; of
/// a jet, half a cell and what is thinner than a cell (breaking_comparison.hpp).
double largest_distance(const exact::overturning::MovingSurface& exact, double time, double cell);

}  // namespace seiche::validation
