/// A bore from depth h1 up to h2 that breaks: what the dispersive models of shallow water share.
///
/// Its Froude number is
///
/// @f[ Fr = \sqrt{\frac{h_2 (h_1 + h_2)}{2 h_1^2}} @f]
///
/// Beside the depth h behind a steady bore, where the water leaves with U in the bore's frame, formula (14) of Frank
/// (1994) with a viscous stress rho nu h u_x is
///
/// @f[ \alpha h^2 U^2 \delta'' + \nu U \delta' + (g h - U^2) \, \delta = 0 @f]
///
/// for the small rest delta of the rise, which dies out without waves if nu >= 2 sqrt(alpha) h sqrt(g h - U^2). With
/// U^2/(g h) = h1 (h1 + h2)/(2 h2^2) of the jump this is the viscosity, c = sqrt(g h):
///
/// @f[ \nu = 2 \sqrt{\alpha} \, h c \, \sqrt{1 - \frac{h_1 (h_1 + h_2)}{2 h_2^2}} @f]
///
/// References: M. Tissier, P. Bonneton, F. Marche, F. Chazel, D. Lannes, Coastal Eng. 67 (2012) 54 (1.3); R. S.
/// Johnson, J. Fluid Mech. 42 (1970) 49 (when a viscous bore has no waves).
#pragma once

#include <cmath>
#include <limits>

namespace seiche::shallow_water {

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

}  // namespace seiche::shallow_water
