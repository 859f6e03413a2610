#include "seiche/models/lagrangian_mesh_3d/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche::lagrangian_mesh_3d {

double surely_stable_step(const Model& model) {
  if (model.settings().gravity == 0) return std::numeric_limits<double>::infinity();
  const Mesh& mesh = model.mesh();
  double height = std::numeric_limits<double>::infinity();
  for (std::size_t cell = mesh.cells() - mesh.plan.cells(); cell < mesh.cells(); ++cell) {
    const auto r = mesh.corners(cell);
    double mean = 0;
    for (std::size_t a = 0; a < 4; ++a) mean += (mesh.z[r[a + 4]] - mesh.z[r[a]]) / 4;
    height = std::min(height, mean);
  }
  return std::sqrt(2 * height / model.settings().gravity);
}

}  // namespace seiche::lagrangian_mesh_3d
