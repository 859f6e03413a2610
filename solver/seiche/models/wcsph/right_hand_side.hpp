/// Rates of change (2)-(4), (6) of all particles: the pair loops in their order, with what they need of each other;
/// internal to Flow.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/settings.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

/// Rates of change, in the order of the particles. Walls have the density's only, the others are zero.
struct Rates {
  std::vector<double> dx, dz, du, dw, ddensity;
};

class RightHandSide {
 public:
  /// @param spacing  dx, the filter width Delta of the turbulence model
  RightHandSide(const Settings& settings, double spacing);

  void resize(std::size_t particles);
  /// Rates at the records of the stage; with `limited` also the limit of the step.
  void evaluate(Stage& stage, const Neighbours& neighbours, bool limited);

  [[nodiscard]] const Rates& rates() const { return rates_; }
  [[nodiscard]] Rates& rates() { return rates_; }
  /// Largest (c + sigma)/h of the last evaluation with `limited` [1/s].
  [[nodiscard]] double largest_limit() const { return largest_limit_; }
  /// A particle beside it: the first of the cluster that has it.
  [[nodiscard]] std::size_t most_limited() const { return most_limited_; }
  /// Whether stresses of unresolved eddies are among the forces.
  [[nodiscard]] bool turbulent() const { return friction_ == Friction::turbulent; }

 private:
  const PairLoops* loops_;
  Friction friction_ = Friction::none;
  PairWork constants_;
  Rates rates_;
  std::vector<double> limit_;  ///< of each cluster
  std::size_t most_limited_ = 0;
  double largest_limit_ = 0;
};

/// What corrects the rates of a step, or the particles after it; internal to Flow.
///
/// Density diffusion of delta-SPH with corrected gradients, between fluid particles:
///
///     D_a = delta c_0 sum_b h_ab (m_b/rho_b) psi_ab . grad W_ab
///     psi_ab = 2 (rho_b - rho_a) r_ba/r^2 - (g_a + g_b)
///     g_a = L_a sum_b (m_b/rho_b) (rho_b - rho_a) grad W_ab,  L_a = [sum_b (m_b/rho_b) r_ba grad W_ab]^-1
///
/// A linear density, hydrostatic water's, is left alone. Where the matrix has no inverse (lone particles, rows) g = 0.
///
/// Density filter, moving least squares of first order:
///
///     rho_a <- sum_b m_b [beta_0 + beta_x (x_a - x_b) + beta_z (z_a - z_b)] W_ab,   beta = A^-1 (1, 0, 0)
///     A = sum_b W_ab (m_b/rho_b) (1, X, Z)^T (1, X, Z)
///
/// Reproduces linear density on any arrangement with A invertible. Otherwise Shepard's mean of at least three
/// neighbours; no change with fewer or where the new value is not within a tenth of rho_0. Conserves mass and momentum,
/// not energy.
///
/// Particle shifting, from where particles are dense to where they are sparse:
///
///     delta r_a = -4 h u_max tau grad C_a,   grad C_a = sum_b V_b [1 + 0.2 (W_ab/W(dx))^4] grad W_ab,   |delta r| <=
///     dx/10
///
/// with the largest speed of all, not the particle's own: lattices break at stagnation points. Velocity and density
/// follow their gradients to the new place. Left alone: particles at the free surface, where sum_b V_b r_ba . grad
/// W_ab, 2 inside the fluid, is below 1.5, and those that have such a neighbour.
///
/// Wall density extrapolated from the fluid beside it:
///
///     P_w = [sum_f P_f W_wf + (g - a_w) . sum_f rho_f (r_w - r_f) W_wf] / sum_f W_wf
///
/// with the wall's acceleration a_w; rho_0 where there is no fluid.
///
/// References: Antuono, Colagrossi, Marrone and Molteni, Comput. Phys. Commun. 181 (2010) 532 (diffusion); Colagrossi
/// and Landrini, J. Comput. Phys. 191 (2003) 448 (filter); Lind, Xu, Stansby and Rogers, J. Comput. Phys. 231 (2012)
/// 1499, Sun, Colagrossi, Marrone and Zhang, Comput. Methods Appl. Mech. Eng. 315 (2017) 25 (shifting, coefficient);
/// Adami, Hu and Adams, J. Comput. Phys. 231 (2012) 7057 (walls).
class Corrections {
 public:
  /// @param spacing  dx
  Corrections(const Settings& settings, double spacing);

  /// Does nothing where delta = 0.
  void add_diffusion(const Stage& stage, const Neighbours& neighbours, std::vector<double>& ddensity);
  /// New densities of the fluid particles, all from the old ones.
  void filter(const Stage& stage, const Neighbours& neighbours, std::vector<double>& density) const;
  /// @param stage  filled with the particles as they are
  void shift(double tau, const Stage& stage, const Neighbours& neighbours, Particles& particles);
  /// Sets the density of wall records. Walls list fluid only: that of other walls is not read.
  /// @param gravity  g - a_w felt at wall particle i
  void extrapolate(const std::function<std::array<double, 2>(std::size_t i)>& gravity, Stage& stage,
                   const Neighbours& neighbours);

 private:
  const PairLoops* loops_;
  TaitFluid fluid_;
  double diffusion_;  ///< delta c_0
  double spacing_;
  double smoothing_;                        ///< h_0
  std::vector<DensityGradient> gradients_;  ///< of the records
  std::vector<double> at_surface_;          ///< of the records, 1 or 0
  std::vector<WallMeans> means_;            ///< of the walls
};

}  // namespace seiche::wcsph
