/// Markers on the surface of a channel and their velocities: what a flow starts from.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "seiche/models/dispersive_shallow_water_1d/channel.hpp"

namespace seiche::dispersive_shallow_water_1d {

/// Ascending markers (x, y), y from the still-water level, and their velocities (u, v) [m/s].
struct Markers {
  std::vector<double> x, y, u, v;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  /// Throws std::invalid_argument: fewer than three markers, arrays of different length, values not finite, markers not
  /// ascending, no water under a marker that is not a tip, a tip that is off the bottom by more than 1e-12 of the
  /// largest depth.
  void validate(const Channel& channel) const;
};

/// The surface at a place: its elevation, the water's horizontal velocity, and the rate at which the depth of the
/// water that is there grows, -H du/dx [m/s].
struct SurfaceMotion {
  double elevation = 0;
  double velocity = 0;
  double thickening = 0;
};

/// Markers of still water at the given places. An end that is a tip must be a place where the bottom is at level 0.
Markers still_markers(const Channel& channel, std::vector<double> x);

/// Places begin, ..., end with `cells` equal intervals; without the last one if the channel is periodic.
std::vector<double> equal_labels(const Channel& channel, double begin, double end, std::size_t cells);

/// Markers of moved water: the water between a marker and `anchor` is what still water has between the marker's label
/// and `anchor`. Equal labels over a level bottom are cells of equal volume.
/// @param labels   ascending places
/// @param motion   the moved surface
/// @param excess   integral of its elevation, from any place
/// @param anchor   a place that is its own label: a shoreline that has not moved yet, a crest
Markers moved_markers(const Channel& channel, std::span<const double> labels,
                      const std::function<SurfaceMotion(double)>& motion, const std::function<double(double)>& excess,
                      double anchor);

/// Serre's solitary wave over a level part of the channel, with the exact kinematics of its equations (alpha of the
/// channel). Reference: Serre, La Houille Blanche 8 (1953) 374.
struct SolitaryStart {
  double amplitude = 0.1;  ///< [m]
  double crest = 0;        ///< place [m]
  double depth = 1;        ///< of the level part [m]
  int direction = 1;       ///< 1 to the right, -1 to the left
};

/// Water between `begin` and `end` with cells of about `spacing` when at rest. A tip is kept where still water has it,
/// and labels count from there in steps of exactly `spacing`: the other end, which must not be a tip, is then moved by
/// the wave's volume. Otherwise both ends are kept and the spacing adapts.
Markers solitary_markers(const Channel& channel, double begin, double end, double spacing, SolitaryStart wave);

}  // namespace seiche::dispersive_shallow_water_1d
