/// A bore meets a vertical wall and runs back: water at rest, deeper than behind the incident bore, between it and the
/// wall.
///
///     u1 = (h2 - h1) sqrt(g (h2 + h1)/(2 h1 h2)),   a- = -u1 h1/(h2 - h1)
///
/// which is the Riemann problem of (h1, u1) against its mirror image.
///
/// When not to use it: after the reflected jump has met another wave.
///
/// References: Stoker, Water Waves (1957), 10.7; Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by
/// the particle method, section 5.
#pragma once

#include <vector>

#include "seiche/exact/bore.hpp"
#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class BoreReflection {
 public:
  /// @param incident  bore that runs to the right;  @param wall  position [m], to the right of the bore at t = 0.
  /// Water ahead of the bore must be at rest. Throws std::invalid_argument.
  BoreReflection(const Bore& incident, double wall);

  /// From the depths ahead (h0) and behind (h1).
  static BoreReflection from_depths(double gravity, double ahead, double behind, double start, double wall);
  /// From depth h1 and velocity u1 behind the incident bore; h0 follows.
  static BoreReflection from_velocity(double gravity, double behind, double behind_velocity, double start, double wall);

  /// State at x <= wall, t >= 0. Throws std::invalid_argument beyond the wall.
  [[nodiscard]] shallow_water::State at(double x, double t) const;
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return {position(t)}; }

  [[nodiscard]] const Bore& incident() const { return incident_; }
  [[nodiscard]] double wall() const { return wall_; }
  /// When the bore meets the wall [s].
  [[nodiscard]] double reflection_time() const { return time_; }
  /// Depth between wall and reflected jump h2 [m].
  [[nodiscard]] double reflected_depth() const { return depth_; }
  /// Velocity of the reflected jump a- < 0 [m/s].
  [[nodiscard]] double reflected_speed() const { return speed_; }
  /// Position of the incident, then of the reflected jump [m].
  [[nodiscard]] double position(double t) const;

  /// See ReferenceSolution.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;
  static Provenance provenance();

 private:
  Bore incident_;
  double wall_;
  double time_;
  double depth_;
  double speed_;
};

}  // namespace seiche::exact
