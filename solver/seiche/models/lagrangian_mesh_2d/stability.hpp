/// Longest stable step of the one-step scheme on a mesh.
#pragma once

#include "seiche/models/lagrangian_mesh_2d/model.hpp"

namespace seiche::lagrangian_mesh_2d {

/// 2/omega of the fastest mode of the undeformed layer with the mesh's mean depth, column width and rows (the closed
/// dispersion law, exact/lagrangian_mesh_dispersion.hpp), with the hourglass potential's added: a bound, from the safe
/// side; infinite where there is neither.
double longest_stable_step(const Model& model);

}  // namespace seiche::lagrangian_mesh_2d
