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
#pragma once

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
  [[nodiscard]] double shift(double t) const;
  [[nodiscard]] double velocity(double t) const;
  [[nodiscard]] double left_shoreline(double t) const;
  [[nodiscard]] double right_shoreline(double t) const;
  /// Position at time t of the water that was at x0 at t = 0 [m].
  [[nodiscard]] double carried(double x0, double t) const;

  /// w = sqrt(2 g h0)/a [1/s], its period [s], and the largest velocity displacement w [m/s].
  [[nodiscard]] double angular_frequency() const { return frequency_; }
  [[nodiscard]] double period() const;
  [[nodiscard]] double velocity_amplitude() const { return displacement_ * frequency_; }
  /// Area of the water, 4 a h0/3 [m^2].
  [[nodiscard]] double area() const { return 4 * radius_ * depth_ / 3; }

  /// See ReferenceSolution.
  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] SelfTest self_test() const;
  static Provenance provenance();

 private:
  double radius_;
  double depth_;
  double centre_;
  double displacement_;
  double frequency_;
};

}  // namespace seiche::exact
