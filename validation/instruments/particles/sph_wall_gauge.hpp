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

#include <cmath>

#include <numbers>
#include <vector>

#include "seiche/models/wcsph/flow.hpp"
#include "seiche/models/wcsph/kernel.hpp"
#include "seiche/require.hpp"

namespace seiche::wcsph {

struct WallGauge {
  double x = 0;         ///< of the wall [m]
  double z = 0;         ///< of the middle of the face [m]
  double diameter = 0;  ///< D [m]; 0: a point
};

/// [Pa]. Throws std::invalid_argument where the diameter is negative.
inline double pressure_on(const WallGauge& gauge, const Flow& flow) {
  require_not_negative("diameter", gauge.diameter);
  const double h = flow.smoothing_length();
  const bool spline = flow.settings().kernel == KernelName::cubic_spline;
  const Particles& p = flow.particles();
  constexpr int nodes = 4;  // heights on the face
  struct Node {
    double z, share;
    double pressures = 0, weights = 0;
  };
  std::vector<Node> heights;
  for (int k = 0; k < nodes; ++k) {
    const double angle = std::numbers::pi * (k + 1) / (nodes + 1);
    // Shares of all nodes add up to 1.
    heights.push_back({.z = gauge.z + 0.5 * gauge.diameter * std::cos(angle),
                       .share = 2 * std::pow(std::sin(angle), 2) / (nodes + 1)});
  }
  for (std::size_t b = 0; b < p.size(); ++b) {
    const double x = gauge.x - p.x[b];
    if (p.kind[b] != Kind::fluid || !(std::abs(x) < support * h) ||
        !(std::abs(gauge.z - p.z[b]) < support * h + 0.5 * gauge.diameter)) {
      continue;
    }
    const double pressure = flow.fluid().pressure(p.density[b]);
    for (Node& node : heights) {
      const double z = node.z - p.z[b];
      const double r = std::hypot(x, z);
      const double w = p.mass[b] / p.density[b] * (spline ? weight<CubicSpline>(r, h) : weight<WendlandC2>(r, h));
      node.pressures += (pressure - p.density[b] * flow.settings().gravity * z) * w;
      node.weights += w;
    }
  }
  double mean = 0;
  for (const Node& node : heights) mean += node.weights > 0 ? node.share * node.pressures / node.weights : 0;
  return mean;
}

}  // namespace seiche::wcsph
