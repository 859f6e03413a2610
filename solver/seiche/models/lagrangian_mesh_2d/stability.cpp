#include "seiche/models/lagrangian_mesh_2d/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "seiche/exact/lagrangian_mesh_dispersion.hpp"

namespace seiche::lagrangian_mesh_2d {

double longest_stable_step(const Model& model) {
  const Mesh& mesh = model.mesh();
  const Settings& settings = model.settings();
  const auto areas = model.first_areas();
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double width = mesh.x[mesh.node(mesh.columns, 0)] - mesh.x[mesh.node(0, 0)];
  const bool layer = !std::holds_alternative<FreeSide>(mesh.sides.bottom) && width > 0;
  double gravity_square = 0;
  if (settings.gravity > 0 && layer) {
    const exact::LagrangianMeshDispersion law(
        settings.gravity, area / width, width / static_cast<double>(mesh.columns), mesh.rows,
        settings.tuned_surface_inertia ? exact::SurfaceInertia::tuned : exact::SurfaceInertia::nodal);
    gravity_square = std::pow(law.largest_frequency(), 2);
  }
  // r0 - r1 + r2 - r3 is four amplitudes in the fastest hourglass motion: omega^2 = 16 kappa/(rho cell's area).
  const double cell = area / static_cast<double>(mesh.cells());
  const double hourglass_square = 16 * settings.hourglass * settings.gravity / std::sqrt(cell);
  // Stiffnesses add, so the square of the fastest of their modes is at most the sum.
  const double square = gravity_square + hourglass_square;
  return square > 0 ? 2 / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

}  // namespace seiche::lagrangian_mesh_2d
