/// Relations of the shallow-water equations that exact solutions and models share: celerity, hydrostatic
/// thrust, the curves of simple waves and of jumps, and the star state of the Riemann problem.
///
///     h_t + (h u)_x = 0,   (h u)_t + (h u^2 + g h^2/2)_x = 0
///
/// Density is 1: multiply thrust and energy by the density of the fluid if it matters.
///
/// Sources: Stoker, Water Waves (1957); Toro, Shock-capturing methods for free-surface shallow flows (2001).
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace seiche::shallow_water {

/// Depth [m] and velocity [m/s] of a uniform flow; depth 0 is a dry bed.
struct State {
  double depth = 0;
  double velocity = 0;
};

/// Celerity of long waves sqrt(g h) [m/s].
inline double celerity(double gravity, double depth) {
  return std::sqrt(gravity * depth);
}

/// Hydrostatic thrust g h^2/2 per unit width and density [m^3/s^2].
inline double thrust(double gravity, double depth) {
  return 0.5 * gravity * depth * depth;
}

/// Velocity change f_K(h) [m/s] across the wave that leads from depth `from` to depth `to`: a simple wave when the
/// depth falls, a hydraulic jump when it rises.
inline double velocity_change(double gravity, double to, double from) {
  if (to <= from) return 2 * (std::sqrt(gravity * to) - std::sqrt(gravity * from));
  return (to - from) * std::sqrt(0.5 * gravity * (to + from) / (to * from));
}

/// Derivative of velocity_change with respect to `to` [1/s].
inline double velocity_change_slope(double gravity, double to, double from) {
  if (to <= from) return std::sqrt(gravity / to);
  const double q = std::sqrt(0.5 * gravity * (to + from) / (to * from));
  return q - gravity * (to - from) / (4 * to * to * q);
}

/// Mass swept per unit time by a jump between two depths, sqrt(g h0 h1 (h0 + h1)/2) [m^2/s]: its speed in mass
/// coordinates, the same for every observer.
inline double jump_mass_flux(double gravity, double depth, double other) {
  return std::sqrt(0.5 * gravity * depth * other * (depth + other));
}

/// True when the two states part so fast that the bed between them dries.
inline bool middle_dries(double gravity, State left, State right) {
  return 2 * (celerity(gravity, left.depth) + celerity(gravity, right.depth)) <= right.velocity - left.velocity;
}

/// Depth of the middle state if both waves were simple waves; exact when it is below both depths, and the starting
/// value of every iteration here. Zero when the middle dries.
inline double two_rarefaction_depth(double gravity, State left, State right) {
  const double c =
      0.5 * (celerity(gravity, left.depth) + celerity(gravity, right.depth)) + 0.25 * (left.velocity - right.velocity);
  return c > 0 ? c * c / gravity : 0.0;
}

/// Middle state of the Riemann problem of two wet states, to round-off. Depth 0 (velocity meaningless) when the
/// middle dries. Both depths must be positive.
State star_state(double gravity, State left, State right);

using ExactProfile = std::function<State(double)>;  ///< x -> depth, velocity

/// What is measured: cells or particles between `edges`, their mean states, and optionally a reconstruction with the
/// positions where it is not smooth. Works for any scheme.
struct MeasuredProfile {
  std::vector<double> edges;
  std::vector<State> means;
  ExactProfile reconstruction;
  std::vector<double> breaks;
};

// A bore from depth h1 up to h2 that breaks: what the dispersive models of shallow water share.
//
// Its Froude number is
//
// @f[ Fr = \sqrt{\frac{h_2 (h_1 + h_2)}{2 h_1^2}} @f]
//
// Beside the depth h behind a steady bore, where the water leaves with U in the bore's frame, formula (14) of Frank
// (1994) with a viscous stress rho nu h u_x is
//
// @f[ \alpha h^2 U^2 \delta'' + \nu U \delta' + (g h - U^2) \, \delta = 0 @f]
//
// for the small rest delta of the rise, which dies out without waves if nu >= 2 sqrt(alpha) h sqrt(g h - U^2). With
// U^2/(g h) = h1 (h1 + h2)/(2 h2^2) of the jump this is the viscosity, c = sqrt(g h):
//
// @f[ \nu = 2 \sqrt{\alpha} \, h c \, \sqrt{1 - \frac{h_1 (h_1 + h_2)}{2 h_2^2}} @f]
//
// References: M. Tissier, P. Bonneton, F. Marche, F. Chazel, D. Lannes, Coastal Eng. 67 (2012) 54 (1.3); R. S.
// Johnson, J. Fluid Mech. 42 (1970) 49 (when a viscous bore has no waves).

/// Froude number below which a bore is undular.
constexpr double weakest_breaking_bore = 1.3;

/// Froude number of the bore from depth `ahead` up by `rise`; infinite on dry ground.
inline double bore_froude(double ahead, double rise) {
  if (!(ahead > 0)) return std::numeric_limits<double>::infinity();
  const double ratio = 1 + rise / ahead;
  return std::sqrt(0.5 * ratio * (1 + ratio));
}

/// Of the same bore, sqrt(1 - U^2/(g h)) behind it; 1 on dry ground.
inline double bore_damping(double ahead, double rise) {
  if (!(ahead > 0)) return 1;
  const double ratio = 1 + rise / ahead;
  return std::sqrt(1 - 0.5 * (1 + ratio) / (ratio * ratio));
}

/// Generalised minmod of the two one-sided slopes and `theta` times them: theta = 1 is minmod, theta = 2 the
/// monotonised central limiter. Zero at an extremum.
///
/// @param backward, forward  one-sided slopes
/// @param central            the slope taken where the function is smooth
inline double limited_slope(double backward, double central, double forward, double theta) {
  if (backward * forward <= 0) return 0;
  const double magnitude = std::min({theta * std::abs(backward), std::abs(central), theta * std::abs(forward)});
  return std::copysign(magnitude, backward);
}

}  // namespace seiche::shallow_water
