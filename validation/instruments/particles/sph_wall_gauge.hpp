/// Pressure that a round gauge in a vertical wall reads: the mean over its face of what the water tells the wall there.
///
///     P(r) = sum_b (m_b/rho_b) [P_b + rho_b g . (r - r_b)] W(|r - r_b|, h_0) / sum_b (m_b/rho_b) W      over the fluid
///
/// the mean of Shepard, with the hydrostatic gradient as walls feel it (corrections.hpp); 0 where there is no water
/// within the kernel. The mean over a disc of diameter D about the height z_0 weighs heights by their chords, which is
/// Gauss-Chebyshev quadrature of the second kind.
///
/// Hydrostatic pressure is exact but for the compression of the water. Another gradient counts as if the wall stood
/// where the weights of the water have their centre, about h/2 inside: the error is of first order in h.
///
/// Reference: Shepard, A two-dimensional interpolation function for irregularly-spaced data, Proc. 23rd ACM National
/// Conference (1968) 517.
#pragma once

#include "seiche/models/wcsph/flow.hpp"

namespace seiche::wcsph {

struct WallGauge {
  double x = 0;         ///< of the wall [m]
  double z = 0;         ///< of the middle of the face [m]
  double diameter = 0;  ///< D [m]; 0: a point
};

/// [Pa]. Throws std::invalid_argument where the diameter is negative.
double pressure_on(const WallGauge& gauge, const Flow& flow);

}  // namespace seiche::wcsph
