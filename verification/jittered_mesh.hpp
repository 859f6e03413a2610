/// Free-Lagrangian meshes without symmetry.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"
#include "seiche/geometry/triangulation.hpp"
#include "seiche/require.hpp"

namespace seiche::free_lagrangian {

/// Nodes inside moved at random, along either axis by up to `part` of the spacing of the mesh, those that slide moved
/// along their wall; free nodes of the outline stay. @param part  in [0, 0.3]. Throws std::invalid_argument.
inline Mesh jittered(Mesh mesh, double part, unsigned long seed) {
  require_within("part", part, 0, 0.3);
  mesh.require_valid();
  const double area = enclosed_area(mesh.places(), mesh.outline);
  // So many nodes of this spacing fill the area: those of the outline count half.
  const double spacing =
      std::sqrt(area / (static_cast<double>(mesh.nodes()) - 0.5 * static_cast<double>(mesh.outline.size())));
  std::mt19937_64 random(seed);
  const auto by = [&] { return part * spacing * (0x1p-52 * static_cast<double>(random() >> 11) - 1); };
  const std::vector<bool> on = mesh.on_outline();
  for (std::size_t k = 0; k < mesh.nodes(); ++k) {
    const Held& held = mesh.held[k];
    if (!on[k]) {
      mesh.x[k] += by();
      mesh.y[k] += by();
    } else if (held.one != Held::by_none && held.other == Held::by_none) {
      const Point along = mesh.walls[static_cast<std::size_t>(held.one)].direction;
      const double length = std::hypot(along.x, along.y);
      const double shift = by();
      // Where the wall ends at the surface, the surface's end stays.
      const auto here = std::find(mesh.outline.begin(), mesh.outline.end(), static_cast<int>(k)) - mesh.outline.begin();
      const auto n = static_cast<std::ptrdiff_t>(mesh.outline.size());
      const auto neighbour = [&](std::ptrdiff_t step) -> const Held& {
        return mesh.held[static_cast<std::size_t>(mesh.outline[static_cast<std::size_t>((here + step + n) % n)])];
      };
      if (neighbour(1).one == Held::by_none || neighbour(-1).one == Held::by_none) continue;
      mesh.x[k] += shift * along.x / length;
      mesh.y[k] += shift * along.y / length;
    }
  }
  return mesh;
}

}  // namespace seiche::free_lagrangian
