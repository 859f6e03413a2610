/// Wall density extrapolated from the fluid beside it; internal to Flow.
///
///     P_w = [sum_f P_f W_wf + (g - a_w) . sum_f rho_f (r_w - r_f) W_wf] / sum_f W_wf
///
/// with the wall's acceleration a_w; rho_0 where there is no fluid.
///
/// Reference: Adami, Hu and Adams, A generalized wall boundary condition for smoothed particle hydrodynamics,
/// J. Comput. Phys. 231 (2012) 7057.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "seiche/models/wcsph/equation_of_state.hpp"
#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/models/wcsph/neighbours.hpp"
#include "seiche/models/wcsph/pair_loops.hpp"
#include "seiche/models/wcsph/stage.hpp"

namespace seiche::wcsph {

class ExtrapolatedWalls {
 public:
  ExtrapolatedWalls(KernelName kernel, const TaitFluid& fluid) : kernel_(kernel), fluid_(fluid) {}
  /// Sets the density of wall records.
  /// @param gravity  g - a_w felt at wall particle i
  void apply(const std::function<std::array<double, 2>(std::size_t i)>& gravity, Stage& stage,
             const Neighbours& neighbours);

 private:
  KernelName kernel_;
  TaitFluid fluid_;
  std::vector<WallMeans> means_;  ///< of all particles; those of the fluid are not used
};

}  // namespace seiche::wcsph
