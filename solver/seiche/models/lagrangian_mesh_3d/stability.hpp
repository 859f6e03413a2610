/// Longest step of the one-step scheme that is surely stable on a mesh.
#pragma once

#include "seiche/models/lagrangian_mesh_3d/model.hpp"

namespace seiche::lagrangian_mesh_3d {

/// 2/omega with omega^2 = 2 g/h: waves on layers of height h have omega^2 = (2 g/h) G R with G, R < 1, whatever their
/// length. h is the smallest height of a cell at the surface of the first mesh; infinite without gravity.
double surely_stable_step(const Model& model);

}  // namespace seiche::lagrangian_mesh_3d
