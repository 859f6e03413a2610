/// Density filter: moving least squares of first order; internal to Flow.
///
///     rho_a <- sum_b m_b [beta_0 + beta_x (x_a - x_b) + beta_z (z_a - z_b)] W_ab,   beta = A^-1 (1, 0, 0)
///     A = sum_b W_ab (m_b/rho_b) (1, X, Z)^T (1, X, Z)
///
/// Reproduces linear density on any arrangement with A invertible. Otherwise Shepard's mean of at least three
/// neighbours; no change with fewer or where the new value is not within a tenth of rho_0. Conserves mass and momentum,
/// not energy.
///
/// Reference: Colagrossi and Landrini, Numerical simulation of interfacial flows by smoothed particle hydrodynamics,
/// J. Comput. Phys. 191 (2003) 448.
#pragma once

#include <vector>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

/// New densities of the fluid particles, all from the old ones.
/// @param smoothing  h_0; @param reference  rho_0
void filter_density(KernelName kernel, double smoothing, double reference, const Stage& stage,
                    const Neighbours& neighbours, std::vector<double>& density);

}  // namespace seiche::wcsph
