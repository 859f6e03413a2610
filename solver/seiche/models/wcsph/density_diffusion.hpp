/// Density diffusion of delta-SPH with corrected gradients, between fluid particles; internal to Flow.
///
///     D_a = delta c_0 sum_b h_ab (m_b/rho_b) psi_ab . grad W_ab
///     psi_ab = 2 (rho_b - rho_a) r_ba/r^2 - (g_a + g_b)
///     g_a = L_a sum_b (m_b/rho_b) (rho_b - rho_a) grad W_ab,  L_a = [sum_b (m_b/rho_b) r_ba grad W_ab]^-1
///
/// A linear density, hydrostatic water's, is left alone. Where the matrix has no inverse (lone particles, rows) g = 0.
///
/// Reference: Antuono, Colagrossi, Marrone and Molteni, Free-surface flows solved by means of SPH schemes with
/// numerical diffusive terms, Comput. Phys. Commun. 181 (2010) 532.
#pragma once

#include <vector>

#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

class DensityDiffusion {
 public:
  explicit DensityDiffusion(const Settings& settings);
  /// Does nothing where delta = 0.
  void add(const Stage& stage, const Neighbours& neighbours, std::vector<double>& ddensity);

 private:
  double strength_;  ///< delta c_0
  KernelName kernel_;
  std::vector<DensityGradient> gradients_;  ///< of the records
};

}  // namespace seiche::wcsph
