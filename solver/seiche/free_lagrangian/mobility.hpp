/// How a node answers a force: by 1/mass, along its wall alone, or not at all in a corner.
#pragma once

#include <vector>

#include "seiche/free_lagrangian/mesh.hpp"

namespace seiche::free_lagrangian {

struct Mobility {
  double xx = 0;
  double xy = 0;
  double yy = 0;

  [[nodiscard]] Point operator()(Point force) const {
    return {xx * force.x + xy * force.y, xy * force.x + yy * force.y};
  }
  [[nodiscard]] Mobility over(double mass) const { return {xx / mass, xy / mass, yy / mass}; }
};

/// Projections on what the walls of a mesh leave free, one per node: mobilities for unit masses.
std::vector<Mobility> freedoms(const Mesh& mesh);

}  // namespace seiche::free_lagrangian
