/// Standing waves of a Lagrangian mesh at rest, from the model's own calls: elevations, frequencies, multipliers.
///
/// Still water is level, so that forces near it depend on the elevations eta of the surface nodes alone, F = -K eta.
/// With C the answer of these elevations to forces on the surface, areas kept,
///
///     eta'' = -C K eta,   C = E^T P W E   (P projects on constant areas, E: forces on surface nodes, upwards),
///
/// a symmetric problem with as many unknowns as the surface has nodes. linear_modes.hpp has all nodes in it, motionless
/// modes too; this is for meshes that are too large for it, and for the load of waves on walls.
///
/// When not to use it: a surface that ends at an inclined wall; an hourglass potential, which acts below the surface.
#pragma once

#include <vector>

#include "seiche/models/lagrangian_mesh_2d/model.hpp"

namespace seiche::validation {

/// One standing wave when it is highest; any scale.
struct SurfaceMode {
  double frequency = 0;             ///< [1/s]
  std::vector<double> elevation;    ///< of the surface nodes [m]
  std::vector<double> multipliers;  ///< of all cells: dynamic pressure [Pa]
};

/// All waves, longest first; without the mode that would lift the whole surface.
std::vector<SurfaceMode> surface_modes(lagrangian_mesh_2d::Model& model);

}  // namespace seiche::validation
