/// Two jumps running into each other, followed exactly in mass coordinates while they share a few particles.
///
/// Shortly before they meet, the two jumps can no longer be told from particle means: one particle holds three states.
/// Their positions are then carried along instead: between the states left | middle | right each jump moves with its
/// constant mass flux, the meeting is one Riemann problem, and the two jumps that leave it move apart. Edge velocities
/// and pressures are time averages of the piecewise constant solution. When three particles lie between the jumps,
/// detection from the means takes over again.
///
/// When not to use it: jumps of the same facing (an overtaking), or one inside a strong rarefaction.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/models/shallow_water_particles/reconstruction.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

// Jumps inside particles: detection, position and the exact time averages with which a jump leaves its particle.
//
// A particle that a jump has entered holds two states. From its volume and its momentum follow the fractions of its
// mass that are already behind the jump; from these the moments at which edge velocity and edge pressure switch from
// the state ahead to the state behind. Isolated jumps are then exact to round-off and stay one particle wide.
//
// When not to use it: on an uneven bed, where the states beside the jump are not uniform.
//
// Sources: Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method (the jump is handed
// from one particle to the next); Aguillon and Chalons, ESAIM M2AN 50 (2016) for the in-cell discontinuity.

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

class Collision {
 public:
  /// @param right_going, left_going  the two jumps, the first one left of the second
  /// @param mass                     particle masses
  Collision(double gravity, const InteriorJump& right_going, const InteriorJump& left_going, const Array& mass);

  /// Particle that holds the left (right) jump now.
  [[nodiscard]] std::size_t left_particle() const { return left_particle_; }
  [[nodiscard]] std::size_t right_particle() const { return right_particle_; }
  [[nodiscard]] bool met() const { return met_; }
  [[nodiscard]] double fastest_mass_flux() const;

  /// States in particle i, at least one layer.
  [[nodiscard]] Structure structure(std::size_t particle, const Array& mass) const;

  /// Time averages over tau at edge `edge` between particles edge-1 and edge; `base` holds before the first passage.
  [[nodiscard]] EdgeState average(std::size_t edge, const Array& mass, double tau, EdgeState base) const;

  /// There is one particle more (less) to the left of the jumps.
  void renumber(bool more);

  /// Moves the jumps by tau; at most one particle each.
  void advance(double tau, const Array& mass);

 private:
  struct Track {  // positions of both jumps at the start of a phase, their mass velocities, and the state between
    double left, right, left_speed, right_speed;
    State between;
  };
  [[nodiscard]] double edge_mass(std::size_t edge, const Array& mass) const;
  [[nodiscard]] Track after_meeting(double position) const;

  double gravity_;
  State left_;
  State right_;
  Track track_;
  bool met_ = false;
  std::size_t origin_;  // mass positions count from the left edge of this particle
  std::size_t left_particle_;
  std::size_t right_particle_;
};

}  // namespace seiche::shallow_water_particles
