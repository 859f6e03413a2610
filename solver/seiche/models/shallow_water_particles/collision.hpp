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

#include <cstddef>

#include "seiche/models/shallow_water_particles/edges.hpp"
#include "seiche/models/shallow_water_particles/hand_over.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"

namespace seiche::shallow_water_particles {

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
