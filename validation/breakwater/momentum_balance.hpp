/// Balance of the horizontal momentum of water between vertical walls over a curved bottom, step by step of Frank's
/// one-step scheme on the Lagrangian mesh.
///
/// What the walls and the bottom exert is found from the pressures of the step, not from what the water did. At the
/// configuration q~ of the step, cells of dynamic pressure lambda, the free surface (the hydrostatic part, counted from
/// the still-water level: the forces of still water cancel) and the hourglass potential push a node by
///
///     F = sum lambda dV/dr - dPi/dr .
///
/// A node on a vertical wall does not move along x: the wall exerts -F_x. A node that slides along the bottom, with
/// tangent t and speed s', keeps F.t; the bottom exerts the rest of F, reversed, and what turns the node's way along
/// the curve, m [s'_1 (t_1 - t~) - s'_0 (t_0 - t~)]/tau, index 0 before and 1 after the step: the centripetal force.
/// The forces of all other nodes cancel, for cells and potentials know no place: the rate of the water's momentum is
/// the sum of the reactions, to rounding.
///
/// When not to use it: driven walls, other bottoms than curves, compositions and the energy-exact step; corner barriers
/// and forcing, which it does not know.
#pragma once

#include <vector>

#include "seiche/models/lagrangian_mesh_2d/flow.hpp"

namespace seiche::validation {

class MomentumBalance {
 public:
  /// @param flow  must outlive this; any time between two steps
  /// @param tau  length of its steps: differences of times are rounded
  MomentumBalance(const lagrangian_mesh_2d::Flow& flow, double tau);

  /// Of one step: forces on the water along x, without those of still water.
  struct Step {
    double time = 0;    ///< the middle of the step
    double rate = 0;    ///< of the water's momentum
    double left = 0;    ///< force of the left wall
    double right = 0;   ///< of the right wall
    double bottom = 0;  ///< of the bottom
    /// What is missing in the balance.
    [[nodiscard]] double defect() const { return rate - (left + right + bottom); }
  };
  /// To be called after every step.
  Step after_step();

 private:
  struct Forces {
    std::vector<double> x, y;
  };
  [[nodiscard]] Forces forces(const std::vector<double>& middle) const;
  void remember();

  const lagrangian_mesh_2d::Flow* flow_;
  std::vector<double> q_, u_;
  double tau_;
  double time_ = 0;
};

}  // namespace seiche::validation
