/// The exact solitary wave on a two-dimensional Lagrangian mesh. Depth and gravity are those of the wave.
#pragma once

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
  [[nodiscard]] std::size_t columns(double length) const;
  /// "h1 = 0.5, 4 rows, tau = 0.1".
  [[nodiscard]] std::string text() const;
};

/// A tank [0, length] of water of the given depth at rest, for layer_mesh.
lagrangian_mesh_2d::Layer tank(double length, double depth, const MeshResolution& resolution);

/// The wave with its crest at a place of such a tank.
struct PlacedWave {
  const exact::SolitaryWave& wave;
  double crest;

  [[nodiscard]] lagrangian_mesh_2d::Mesh mesh(double length, const MeshResolution& resolution) const;
  /// Exact velocities.
  [[nodiscard]] Point velocity(Point place) const;
  [[nodiscard]] double surface_potential(double x) const { return wave.surface_potential(x - crest); }
};

}  // namespace seiche::validation
