/// Symbol of the pressure matrix A = J M^-1 J^T of an undeformed hexahedral mesh (Frank 1994, 4.1): between vertical
/// walls, on a level bottom, under a free surface.
///
/// Cells are h1 x h2 in plan; layer l = 0..n-1, counted from the bottom, is h_l high. A node of level l = 0..n carries
/// the mass m_l = rho h1 h2 (h_{l-1} + h_l)/2, and cannot move vertically on the bottom. With cosines of phases theta
/// and psi per cell along the two horizontal directions, c1 = cos(theta/2), s1 = sin(theta/2), c2, s2 of psi,
/// multipliers lambda_l give
///
///     lambda . A lambda = sum_l [ ((h2 s1 c2)^2 + (h1 s2 c1)^2) (h_{l-1} lambda_{l-1} + h_l lambda_l)^2
///                               + (h1 h2 c1 c2)^2 (lambda_{l-1} - lambda_l)^2, l > 0 ]/m_l,
///
/// where h and lambda outside 0..n-1 are zero.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace seiche::linear {

class HexahedralLattice {
 public:
  /// @param hx, hy  h1, h2 [m];  @param layer_heights  from the bottom up [m];  @param density  rho [kg/m^3]
  /// @param free_bottom  whether nodes of level 0 move vertically too
  /// Throws std::invalid_argument for an empty or not positive size.
  HexahedralLattice(double hx, double hy, std::vector<double> layer_heights, double density = 1,
                    bool free_bottom = false);

  /// Tridiagonal matrix over the layers, as CosineLattice asks for it.
  void operator()(double theta, double psi, std::span<double> diagonal, std::span<double> off_diagonal) const;

 private:
  double hx_, hy_;
  std::vector<double> layer_heights_;
  std::vector<double> mobility_;  // 1/m_l of the levels
  bool free_bottom_;
};

}  // namespace seiche::linear
