/// Oscillations of water in a paraboloidal bowl in plan (Thacker): radially symmetric, and planar with a rotating
/// shift. The channel version is Thacker (thacker.hpp).
///
/// Bed z = -h0 (1 - r^2/a^2), y = 0 at the rim's level.
///
/// Radial, A = (a^2 - r0^2)/(a^2 + r0^2), w = sqrt(8 g h0)/a, D = 1 - A cos(w t):
///
///     eta = h0 (sqrt(1 - A^2)/D - 1 - (r^2/a^2) ((1 - A^2)/D^2 - 1)),   u_r = r D'/(2 D).
///
/// The water is a paraboloid, h = h0 (sqrt(1 - A^2)/D) (1 - r^2/r_s^2), with shoreline r_s^2 = a^2 D/sqrt(1 - A^2): it
/// starts at r_s = sqrt(a r0), not at r0 as is often said. Every particle keeps r/sqrt(D).
///
/// Planar, w = sqrt(2 g h0)/a, displacement s:
///
///     eta = (s h0/a^2) (2 x cos(w t) + 2 y sin(w t) - s),   (u, v) = s w (-sin(w t), cos(w t)):
///
/// the disc of water of radius a moves without rotation, its centre on the circle of radius s.
///
/// When not to use it: other bed shapes, friction, rotation of the earth.
///
/// References: Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981)
/// 499; Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269, section 4.2.2.
#pragma once

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

/// Water of a bowl above one point of the plane: depth [m] and velocity [m/s], zero where dry.
struct BowlState {
  double depth = 0;
  double u = 0;
  double v = 0;
};

struct PlanePoint {
  double x = 0;
  double y = 0;
};

class ThackerRadialBowl {
 public:
  /// @param gravity [m/s^2];  @param radius a [m];  @param depth h0 [m]
  /// @param start_radius  r0 [m], 0 < r0 < radius: the water starts at rest inside the circle of radius sqrt(a r0)
  /// Throws std::invalid_argument.
  ThackerRadialBowl(double gravity, double radius, double depth, double start_radius);

  [[nodiscard]] BowlState at(double x, double y, double t) const;
  /// Level of the free surface [m]; continued by its formula below the dry bed.
  [[nodiscard]] double surface(double x, double y, double t) const;
  [[nodiscard]] double bed(double x, double y) const;
  [[nodiscard]] double shoreline(double t) const;
  /// Where the water that was at `start` at t = 0 is at time t.
  [[nodiscard]] PlanePoint carried(PlanePoint start, double t) const;

  [[nodiscard]] double angular_frequency() const { return frequency_; }
  [[nodiscard]] double period() const;
  /// pi a^2 h0/2 [m^3]: as much as fills the bowl to its rim.
  [[nodiscard]] double volume() const;
  /// Kinetic and potential energy over density [m^5/s^2], relative to the rim's level; constant.
  [[nodiscard]] double energy() const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double stretch(double t) const;  // D

  double gravity_;
  double radius_;
  double depth_;
  double amplitude_;  // A
  double frequency_;
};

class ThackerPlanarBowl {
 public:
  /// @param gravity [m/s^2];  @param radius a [m];  @param depth h0 [m];  @param displacement s > 0 [m]
  /// Throws std::invalid_argument.
  ThackerPlanarBowl(double gravity, double radius, double depth, double displacement);

  [[nodiscard]] BowlState at(double x, double y, double t) const;
  /// Level of the free surface, a plane [m]; continued below the dry bed.
  [[nodiscard]] double surface(double x, double y, double t) const;
  [[nodiscard]] double bed(double x, double y) const;
  /// Centre of the disc of water.
  [[nodiscard]] PlanePoint centre(double t) const;
  /// Where the water that was at `start` at t = 0 is at time t.
  [[nodiscard]] PlanePoint carried(PlanePoint start, double t) const;

  [[nodiscard]] double angular_frequency() const { return frequency_; }
  [[nodiscard]] double period() const;
  /// pi a^2 h0/2 [m^3].
  [[nodiscard]] double volume() const;

  static Provenance provenance();
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;

 private:
  double radius_;
  double depth_;
  double displacement_;
  double frequency_;
};

}  // namespace seiche::exact
