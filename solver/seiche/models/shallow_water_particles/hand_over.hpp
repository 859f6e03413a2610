/// Jumps inside particles: detection, position and the exact time averages with which a jump leaves its particle.
///
/// A particle that a jump has entered holds two states. From its volume and its momentum follow the fractions of its
/// mass that are already behind the jump; from these the moments at which edge velocity and edge pressure switch from
/// the state ahead to the state behind. Isolated jumps are then exact to round-off and stay one particle wide.
///
/// When not to use it: on an uneven bed, where the states beside the jump are not uniform.
///
/// Sources: Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method (the jump is handed
/// from one particle to the next); Aguillon and Chalons, ESAIM M2AN 50 (2016) for the in-cell discontinuity.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

using shallow_water::State;

enum class Facing { left, right };  ///< direction a jump moves in relative to the water

/// A jump found inside a particle.
struct InteriorJump {
  std::size_t particle = 0;
  Facing facing = Facing::right;
  State behind;
  State ahead;
  double behind_by_volume = 0;    ///< fraction of the particle's mass behind the jump, from its volume
  double behind_by_momentum = 0;  ///< the same from its momentum; equal for an isolated jump
  double mass_flux = 0;           ///< mass swept per unit time [m^2/s]
  bool leaves_through_wall = false;
  State reflected;  ///< state behind the reflected jump, when it leaves through a wall

  [[nodiscard]] double size() const;
  /// Whether both fractions place it inside the particle, by 1e-9: round-off alone is no jump.
  [[nodiscard]] bool inside() const;
  [[nodiscard]] State at_left() const { return facing == Facing::right ? behind : ahead; }
  [[nodiscard]] State at_right() const { return facing == Facing::right ? ahead : behind; }
};

/// Part of a particle, from its left edge on, in one state.
struct Layer {
  State state;
  double mass_fraction = 0;
};

/// Up to three states in one particle.
struct Structure {
  std::size_t particle = 0;
  std::array<Layer, 3> layers{};
  int count = 0;

  [[nodiscard]] State at_left() const { return layers[0].state; }
  [[nodiscard]] State at_right() const { return layers[static_cast<std::size_t>(count - 1)].state; }
};

/// Layers of a particle with one jump.
Structure structure_of(const InteriorJump& jump);

/// Jump in a particle with means `mean` between the uniform states of its neighbours, if there is one.
///
/// The candidate is the stronger jump of the Riemann problem of the two neighbours; it counts when its relative height
/// exceeds `threshold` and both fractions place it inside the particle. The guard 1e-9 keeps round-off from flagging a
/// particle that has just been completed.
std::optional<InteriorJump> jump_between(double gravity, State left, State mean, State right, double threshold);

/// Replaces the time averages over tau at the edge through which the jump leaves, if it leaves within the step.
/// `velocity`, `thrust`: averages at that edge as computed with the state ahead.
void hand_over(double gravity, const InteriorJump& jump, double mass, double tau, double& velocity, double& thrust);

}  // namespace seiche::shallow_water_particles
