/// Particle shifting: moves particles from where they are dense to where they are sparse; internal to Flow.
///
///     delta r_a = -4 h u_max tau grad C_a,   grad C_a = sum_b V_b [1 + 0.2 (W_ab/W(dx))^4] grad W_ab,   |delta r| <=
///     dx/10
///
/// with the largest speed of all, not the particle's own: lattices break at stagnation points. Velocity and density
/// follow their gradients to the new place. Left alone: particles at the free surface, where sum_b V_b r_ba . grad
/// W_ab, 2 inside the fluid, is below 1.5, and those that have such a neighbour.
///
/// References: Lind, Xu, Stansby and Rogers, Incompressible smoothed particle hydrodynamics for free-surface flows,
/// J. Comput. Phys. 231 (2012) 1499; Sun, Colagrossi, Marrone and Zhang, The delta-plus-SPH model, Comput. Methods
/// Appl. Mech. Eng. 315 (2017) 25 (coefficient).
#pragma once

#include <vector>

#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/particles.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

class ParticleShifting {
 public:
  ParticleShifting(KernelName kernel, double spacing) : kernel_(kernel), spacing_(spacing) {}
  /// @param stage  filled with the particles as they are
  void apply(double tau, const Stage& stage, const Neighbours& neighbours, Particles& particles);

 private:
  KernelName kernel_;
  double spacing_;
  std::vector<double> at_surface_;  ///< of the records, 1 or 0
};

}  // namespace seiche::wcsph
