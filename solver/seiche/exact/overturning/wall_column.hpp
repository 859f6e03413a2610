/// Pressure in the water along a wall of symmetry, at one moment of a motion that is even about x = pi.
///
/// On the surface the rate of the potential is known, phi_t = -|f|^2/2 - y. It is the surface value of a harmonic
/// function whose normal derivative vanishes on bottom and walls, as that of the potential does, so that the same
/// integral equation (surface_velocity.hpp) gives its conjugate. Both complex potentials, W = phi + i psi and W_t, are
/// real on bottom and walls: in the variable
///
///     P(z) = sin^2((z + ih - pi)/2),
///
/// which takes the same value at z, at its image in the wall and, conjugated, at that in the bottom, W, W_t and
/// f/P' = dW/dP are single-valued, and the quotient of two Cauchy sums (conformal_wave.hpp) continues them from half
/// of the surface. Along the wall
///
///     p = -phi_t - v^2/2 - y   (density 1, g = 1).
///
/// When not to use it: motions that are not even about x = pi, or a pressure on the surface.
#pragma once

#include <cmath>
#include <numbers>

#include "seiche/exact/conformal_wave.hpp"
#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact::overturning {

class WallColumn {
 public:
  /// @param depth     finite
  /// @param equation  of this depth and as many markers; solved once
  WallColumn(const Moment& moment, double depth, SurfaceVelocity& equation);

  [[nodiscard]] double level() const { return level_; }  ///< of the water at the wall
  /// Hydrostatic part included, at -depth <= y <= level().
  [[nodiscard]] double pressure(double y) const { return pressure({0, y + depth_}, y); }
  /// phi at the foot of the wall.
  [[nodiscard]] double foot_potential() const { return potential_.at(0, 0, potential_.size()).real(); }
  /// int p dy over the wall.
  [[nodiscard]] double force() const { return force(0, level_); }
  /// The same over the wall at x = 0.
  [[nodiscard]] double opposite_force() const { return force(std::numbers::pi, opposite_level_); }
  /// int int u dx dy over the water between the two walls.
  [[nodiscard]] double impulse() const { return impulse_; }

 private:
  /// At a place z + ih - pi.
  [[nodiscard]] double pressure(std::complex<double> place, double y) const;
  [[nodiscard]] double force(double x, double level) const;

  double depth_, level_, opposite_level_;
  double impulse_ = 0;
  CauchyVelocity potential_;  ///< W
  CauchyVelocity rate_;       ///< W_t
  CauchyVelocity slope_;      ///< dW/dP
};

}  // namespace seiche::exact::overturning
