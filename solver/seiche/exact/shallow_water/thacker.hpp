/// Planar oscillation of water in a parabolic bowl (Thacker), in one dimension, with any amplitude.
///
/// Bed z = depth ((x - length/2)^2/radius^2 - 1). Seek water that moves as a rigid body, u = xi'(t), with its parabola
/// shifted by xi:
///
///     h = depth (1 - ((x - length/2 - xi)/radius)^2),   h + z = depth (2 (x - length/2) xi - xi^2)/radius^2.
///
/// Continuity holds because h is only translated, and the surface is a plane, so momentum gives
/// xi'' = -g (h + z)_x = -w^2 xi with w = sqrt(2 g depth)/radius: xi = -displacement cos(w t) for any displacement.
/// The published case is displacement = radius/2. Every particle moves by the same xi: edges are exact references.
///
/// When not to use it: other bed shapes, friction.
///
/// References: Thacker, Some exact solutions to the nonlinear shallow-water wave equations, J. Fluid Mech. 107 (1981)
/// 499; Delestre et al., SWASHES, Int. J. Numer. Meth. Fluids 72 (2013) 269, section 4.2.1.
///
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

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::exact {

class Thacker {
 public:
  /// @param radius        half-width of the water a [m];  @param depth  depth of the bowl h0 [m]
  /// @param length        channel [0, length] with the bowl in its middle [m]; must hold the water at every time
  /// @param displacement  amplitude of the motion [m], 0 < displacement <= length/2 - radius; radius/2 if not given
  /// Throws std::invalid_argument.
  Thacker(double gravity, double radius, double depth, double length, std::optional<double> displacement = {});

  /// State at (x, t); velocity 0 where dry.
  [[nodiscard]] shallow_water::State at(double x, double t) const;
  /// The two shorelines [m].
  [[nodiscard]] std::vector<double> breakpoints(double t) const { return {left_shoreline(t), right_shoreline(t)}; }

  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] Bed bed() const;
  /// Displacement xi(t) = -displacement cos(w t) [m] and velocity xi'(t) [m/s], common to all the water.
  [[nodiscard]] double shift(double t) const { return -displacement_ * std::cos(frequency_ * t); }
  [[nodiscard]] double velocity(double t) const { return displacement_ * frequency_ * std::sin(frequency_ * t); }
  [[nodiscard]] double left_shoreline(double t) const { return centre_ + shift(t) - radius_; }
  [[nodiscard]] double right_shoreline(double t) const { return centre_ + shift(t) + radius_; }
  /// Position at time t of the water that was at x0 at t = 0 [m].
  [[nodiscard]] double carried(double x0, double t) const;

  /// w = sqrt(2 g h0)/a [1/s], its period [s], and the largest velocity displacement w [m/s].
  [[nodiscard]] double angular_frequency() const { return frequency_; }
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / frequency_; }
  [[nodiscard]] double velocity_amplitude() const { return displacement_ * frequency_; }
  /// Area of the water, 4 a h0/3 [m^2].
  [[nodiscard]] double area() const { return 4 * radius_ * depth_ / 3; }

  // Twenty roundings where the channel is four radii long, of x up to its length.
  [[nodiscard]] double uncertainty() const { return 10 * centre_ / radius_ * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double radius_, depth_, centre_, displacement_, frequency_;
};

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

/// A paraboloid of radius a and depth h0 with as much water as fills it to its rim.
class ThackerBowl {
 public:
  /// Elevation of the bed at a place relative to the bowl's centre.
  [[nodiscard]] double bed(double x, double y) const;
  [[nodiscard]] double angular_frequency() const { return frequency_; }
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / frequency_; }
  /// pi a^2 h0/2 [m^3].
  [[nodiscard]] double volume() const { return 0.5 * std::numbers::pi * radius_ * radius_ * depth_; }

 protected:
  /// @param gravity [m/s^2];  @param radius a [m];  @param depth h0 [m];  @param factor  w^2 a^2/(g h0)
  ThackerBowl(double gravity, double radius, double depth, double factor);

  double gravity_, radius_, depth_, frequency_;
};

class ThackerRadialBowl : public ThackerBowl {
 public:
  /// @param start_radius  r0 [m], 0 < r0 < radius: the water starts at rest inside the circle of radius sqrt(a r0)
  /// Throws std::invalid_argument.
  ThackerRadialBowl(double gravity, double radius, double depth, double start_radius);

  [[nodiscard]] BowlState at(double x, double y, double t) const;
  /// Level of the free surface [m]; continued by its formula below the dry bed.
  [[nodiscard]] double surface(double x, double y, double t) const;
  [[nodiscard]] double shoreline(double t) const {
    return radius_ * std::sqrt(stretch(t) / std::sqrt((1 - amplitude_) * (1 + amplitude_)));
  }
  /// Where the water that was at `start` at t = 0 is at time t.
  [[nodiscard]] PlanePoint carried(PlanePoint start, double t) const;
  /// Kinetic and potential energy over density [m^5/s^2], relative to the rim's level; constant.
  [[nodiscard]] double energy() const;

  // 1 - A cos(w t) cancels to 1 - A once a period.
  [[nodiscard]] double uncertainty() const { return 20 * epsilon / (1 - amplitude_); }
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double stretch(double t) const;  // D
  /// sqrt(1 - A^2)/D: depth in the middle over h0.
  [[nodiscard]] double middle(double t) const { return std::sqrt((1 - amplitude_) * (1 + amplitude_)) / stretch(t); }

  double amplitude_;  // A
};

class ThackerPlanarBowl : public ThackerBowl {
 public:
  /// @param displacement  s > 0 [m]. Throws std::invalid_argument.
  ThackerPlanarBowl(double gravity, double radius, double depth, double displacement);

  [[nodiscard]] BowlState at(double x, double y, double t) const;
  /// Level of the free surface, a plane [m]; continued below the dry bed.
  [[nodiscard]] double surface(double x, double y, double t) const;
  /// Centre of the disc of water.
  [[nodiscard]] PlanePoint centre(double t) const;
  /// Where the water that was at `start` at t = 0 is at time t.
  [[nodiscard]] PlanePoint carried(PlanePoint start, double t) const;

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double displacement_;
};

}  // namespace seiche::exact
