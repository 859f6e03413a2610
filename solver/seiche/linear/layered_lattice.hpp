/// Symbol of the pressure matrix A = J M^-1 J^T of an undeformed quadrilateral mesh in a vertical plane (Frank 1994,
/// ch. 2): between vertical walls, on a level bottom, under a free surface.
///
/// Cells are h1 wide; row j = 0..ny-1, counted from the bottom, is h2_j high. A node of row j = 0..ny carries the mass
/// m_j = rho h1 (h2_{j-1} + h2_j)/2 and moves with mobility 1/m_j, except vertically on the bottom. With one cosine of
/// phase theta per cell in the horizontal, multipliers lambda_j give
///
///     lambda . A lambda = sum_j [ sin^2(theta/2) (h2_{j-1} lambda_{j-1} + h2_j lambda_j)^2 / m_j        (horizontal)
///                               + cos^2(theta/2) h1^2 (lambda_{j-1} - lambda_j)^2 / m_j ],  j > 0      (vertical)
///
/// where h2 and lambda outside 0..ny-1 are zero.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace seiche::linear {

class LayeredLattice {
 public:
  /// @param column_width  h1 [m];  @param row_heights  h2 from the bottom up [m];  @param density  rho [kg/m^3]
  /// Throws std::invalid_argument for an empty or not positive size.
  LayeredLattice(double column_width, std::vector<double> row_heights, double density = 1);

  /// Tridiagonal matrix over the rows, as CosineLattice asks for it; psi is not used.
  void operator()(double theta, double psi, std::span<double> diagonal, std::span<double> off_diagonal) const;

 private:
  double column_width_;
  std::vector<double> row_heights_;
  std::vector<double> mobility_;  // 1/m_j of the node rows
};

}  // namespace seiche::linear
