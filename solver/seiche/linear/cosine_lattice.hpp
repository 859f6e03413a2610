/// Exact inverse, in single precision, of the matrix of an undeformed lattice between walls: a preconditioner.
///
/// The unknowns sit at the centres of nx x nz columns of equal width, `layers` in each; unknown (ix, iz, layer) has
/// index (layer nz + iz) nx + ix. The matrix may couple anything as long as it is the same for all columns and the
/// walls reflect: then cosines in both horizontal directions diagonalise it, and each pair of phases
///
///     theta = pi m/nx, m = 0..nx-1,      psi = pi l/nz, l = 0..nz-1      (phase per column)
///
/// leaves a symmetric positive definite tridiagonal system over the layers. A vertical plane has nz = 1, a plan view
/// one layer. Costs O(log nx + log nz) operations per unknown and two single-precision numbers of memory.
///
/// Everything inside is single precision, which a preconditioner does not feel and which halves the memory traffic.
/// What is transformed along both never leaves the cache: it is solved for and transformed back in tiles. Threads share
/// rows and modes; results do not depend on their number.
///
/// When not to use it: as a solver; the error is 1e-7 times the condition number of the tridiagonal systems.
///
/// Reference: Buzbee, Golub & Nielson, On direct methods for solving Poisson's equations, SIAM J. Numer. Anal. 7 (1970)
/// 627.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "seiche/linear/fourier.hpp"

namespace seiche::linear {

class CosineLattice {
 public:
  struct Shape {
    std::size_t nx = 1;
    std::size_t nz = 1;
    std::size_t layers = 1;
  };
  /// Sets the matrix over the layers for one pair of phases: diagonal of `layers`, off_diagonal of layers - 1 entries.
  using LayerMatrix =
      std::function<void(double theta, double psi, std::span<double> diagonal, std::span<double> off_diagonal)>;

  /// Throws std::invalid_argument for an empty shape, NotPositiveDefinite with the layer.
  CosineLattice(Shape shape, const LayerMatrix& matrix);

  [[nodiscard]] const Shape& shape() const { return shape_; }

  /// x = S A^-1 S right_hand_side; the two may be the same memory.
  ///
  /// @param magnitude  typical size of the right-hand side, which is divided by it: single precision ends at 1e-38
  /// @param scale      the diagonal of S; empty for 1
  void solve(std::span<const double> right_hand_side, std::span<double> x, double magnitude = 1,
             std::span<const double> scale = {});

 private:
  /// What one thread works with. A row without a partner is transformed together with a copy of itself.
  struct Workspace {
    CosineTransform::Workspace along_x, along_z;
    std::vector<float> row, next, mode_copy;
    std::vector<float> modes;  // of a tile: [layer][position along x][position along z]; none in a plane
  };

  void factor(const LayerMatrix& matrix);
  void grow_workspaces();
  template <class Act>
  void each_pair(const Act& act);
  void transform_rows(const double* right_hand_side, double factor, const double* scale);
  void transform_rows_back(double factor, double* x, const double* scale);
  void solve_tile(std::size_t first, std::size_t last, Workspace& work);

  Shape shape_;
  CosineTransform along_x_, along_z_;
  std::vector<Workspace> workspaces_;  // one per thread
  std::size_t row_stride_;             // from row to row along x
  std::size_t mode_stride_;            // from row to row along z
  std::size_t tile_;                   // rows along z that are transposed together: one cache line of each row along x
  std::vector<float> rows_;            // transformed along x: [layer][iz][position]
  // L D L^T of the systems, in blocks of modes: [block][layer][mode of the block].
  std::vector<float> inverse_pivot_, multiplier_;
};

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
/// @param hx, hy  h1, h2 [m];  @param layer_heights  from the bottom up [m];  @param density  rho [kg/m^3]
/// @param free_bottom  whether nodes of level 0 move vertically too
/// Throws std::invalid_argument for an empty or not positive size.
CosineLattice::LayerMatrix hexahedral_lattice(double hx, double hy, std::vector<double> layer_heights,
                                              double density = 1, bool free_bottom = false);

}  // namespace seiche::linear
