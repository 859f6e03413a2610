/// The exact solitary wave on a two-dimensional Lagrangian mesh. Depth and gravity are those of the wave.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "seiche/exact/solitary_wave.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "seiche/models/lagrangian_mesh_2d/layer.hpp"

namespace seiche::validation {

/// How fine a mesh is, in space and time.
struct MeshResolution {
  double column_width = 1;  ///< h1 [m]
  long rows = 2;
  double tau = 0.1;  ///< [s]

  /// Columns that fill a length.
  [[nodiscard]] std::size_t columns(double length) const {
    return static_cast<std::size_t>(std::max(1L, std::lround(length / column_width)));
  }
  /// "h1 = 0.5, 4 rows, tau = 0.1".
  [[nodiscard]] std::string text() const {
    return fmt::format("h1 = {:.3g}, {} rows, tau = {:.3g}", column_width, rows, tau);
  }
};

/// A tank [0, length] of water of the given depth at rest, for layer_mesh.
inline lagrangian_mesh_2d::Layer tank(double length, double depth, const MeshResolution& resolution) {
  return {.begin = 0,
          .end = length,
          .depth = depth,
          .columns = resolution.columns(length),
          .rows = static_cast<std::size_t>(resolution.rows)};
}

/// The wave with its crest at a place of such a tank.
struct PlacedWave {
  const exact::SolitaryWave& wave;
  double crest;

  [[nodiscard]] lagrangian_mesh_2d::Mesh mesh(double length, const MeshResolution& resolution) const {
    lagrangian_mesh_2d::Layer layer = tank(length, wave.depth(), resolution);
    layer.elevation = [this](double x) { return wave.elevation(x - crest); };
    return layer_mesh(layer);
  }
  /// Exact velocities.
  [[nodiscard]] Point velocity(Point place) const {
    const exact::Velocity v = wave.velocity(place.x - crest, place.y);
    return {v.u, v.v};
  }
  [[nodiscard]] double surface_potential(double x) const { return wave.surface_potential(x - crest); }
};

}  // namespace seiche::validation
