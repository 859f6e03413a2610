/// The rearrangement of Bogomolov, Zakharov and Zerkal as it is written.
///
/// A step: every rectangle moves with its velocity; pairs that overlap or part are rebuilt, from left to right again
/// and again until all touch; from the new depths follow pressures, from these new velocities. In an overlap the
/// particle of smaller density is rebuilt, at a gap the faster one, by moving its side to its neighbour's. If it would
/// become denser than the neighbour, its position changes as well (their figure 4): it gets the neighbour's density,
/// and its far side moves. The pressure at a shared side, which the text leaves open, is that of the particle that was
/// rebuilt.
///
/// Densities that differ by less than 1e-9 of themselves are equal (the particle on the right is then rebuilt), and
/// sides nearer than 1e-11 of the row's length touch: compared by < and == in doubles, a sweep goes back and forth over
/// one unit in the last place and does not end.
///
/// Mass is exact. Momentum changes by the impulses of the ends alone, for every shared side has one pressure; a
/// piston's impulse includes what gives the particle beside it the piston's velocity. A dry bed beyond an end does not
/// push.
///
/// When not to use it: to compute; see ParticleFlow. A bore is one particle wide, but behind it the depth wanders by a
/// per cent, and the front of a dam break on a dry bed is a rectangle.
///
/// Source: Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, section 3, figures
/// 3 and 4.
#pragma once

#include <numeric>
#include <optional>
#include <vector>

#include "seiche/compensated_sum.hpp"
#include "seiche/models/shallow_water_particles/particle_flow.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

class AsWritten {
 public:
  /// @param ends  none Open
  AsWritten(const shallow_water_particles::Particles& initial, shallow_water_particles::Ends ends,
            double gravity = 9.81);

  /// One step. Throws seiche::Divergence where pairs cannot be made to touch, and leaves the row as it was.
  void advance(double tau);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] std::size_t size() const { return row_.mass.size(); }
  [[nodiscard]] double depth(std::size_t i) const { return row_.depth(i); }
  [[nodiscard]] double velocity(std::size_t i) const { return row_.velocity[i]; }
  [[nodiscard]] double mass(std::size_t i) const { return row_.mass[i]; }
  /// Of a particle by a wave: its width over the celerity there [s].
  [[nodiscard]] double shortest_crossing() const;
  [[nodiscard]] double largest_courant() const { return largest_courant_.value(); }
  /// Mass less the initial one [m^2].
  [[nodiscard]] double mass_defect() const { return mass() - initial_mass_; }
  /// Momentum less the initial one and the impulses of the ends [m^3/s].
  [[nodiscard]] double momentum_defect() const { return momentum() - impulse_.value(); }
  /// Sides of the rectangles from left to right.
  [[nodiscard]] std::vector<double> edges() const;

 private:
  struct Row {
    std::vector<double> left, right, mass, velocity;
    [[nodiscard]] double depth(std::size_t i) const { return mass[i] / (right[i] - left[i]); }
  };
  /// Returns whether the right one of the pair (i, i + 1) was rebuilt.
  static bool rebuild(Row& row, std::size_t i);
  [[nodiscard]] double mass() const { return std::accumulate(row_.mass.begin(), row_.mass.end(), 0.0); }
  [[nodiscard]] double momentum() const { return shallow_water_particles::total_momentum(row_.mass, row_.velocity); }
  /// What moves an end: a velocity, or nothing where it goes with its particle.
  [[nodiscard]] std::optional<double> end_velocity(bool right, double time) const;

  Row row_;
  shallow_water_particles::Ends ends_;
  double gravity_;
  double initial_mass_ = mass();
  Largest largest_courant_;
  CompensatedSum impulse_;  ///< and the initial momentum
  double time_ = 0;
  long steps_ = 0;
};

}  // namespace seiche::validation
