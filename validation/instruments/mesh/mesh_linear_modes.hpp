/// Small motions of a Lagrangian mesh about still water, from the model's own calls.
///
/// Rates that keep all areas, u = Q Z c with Q mass-orthonormal and Z a basis of the kernel of J Q, obey
///
///     c'' = -S c,   S = Z^T Q^T M (-dF/du) Q Z   (symmetric),   omega^2 its eigenvalues.
///
/// dF is a central difference of the model's forces. On straight walls these are quadratic in the displacement: the
/// difference is then exact but for rounding.
///
/// When not to use it: more than some thousand nodes (dense matrices).
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "seiche/models/lagrangian_mesh_2d/model.hpp"

namespace seiche::validation {

struct LinearModes {
  std::vector<double> frequencies;  ///< of the waves, ascending [1/s]
  Eigen::MatrixXd rates;            ///< a column per wave: velocities along x, along y, of kinetic energy 1/2
  std::size_t motionless = 0;       ///< modes without frequency
  double asymmetry = 0;             ///< largest |S - S^T| over the largest |S|
};

/// @param model         with its mesh at rest; left linearised there
/// @param displacement  of a node [m]: below a cell's size, and small beside the radius of curved walls
LinearModes linear_modes(lagrangian_mesh_2d::Model& model, double displacement);

}  // namespace seiche::validation
