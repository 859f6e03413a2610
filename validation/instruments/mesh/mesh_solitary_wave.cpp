#include "validation/instruments/mesh/mesh_solitary_wave.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace seiche::validation {

using lagrangian_mesh_2d::Layer;

std::size_t MeshResolution::columns(double length) const {
  return static_cast<std::size_t>(std::max(1L, std::lround(length / column_width)));
}

std::string MeshResolution::text() const {
  return fmt::format("h1 = {:.3g}, {} rows, tau = {:.3g}", column_width, rows, tau);
}

Layer tank(double length, double depth, const MeshResolution& resolution) {
  return {.begin = 0,
          .end = length,
          .depth = depth,
          .columns = resolution.columns(length),
          .rows = static_cast<std::size_t>(resolution.rows)};
}

lagrangian_mesh_2d::Mesh PlacedWave::mesh(double length, const MeshResolution& resolution) const {
  Layer layer = tank(length, wave.depth(), resolution);
  layer.elevation = [this](double x) { return wave.elevation(x - crest); };
  return layer_mesh(layer);
}

Point PlacedWave::velocity(Point place) const {
  const exact::Velocity v = wave.velocity(place.x - crest, place.y);
  return {v.u, v.v};
}

}  // namespace seiche::validation
