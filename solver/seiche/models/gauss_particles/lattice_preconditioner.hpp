/// Exact inverse of the normal equations of a rectangle full of water: a preconditioner for those of any water in it.
///
/// Over a rectangle the sums over particles are nearly integrals, and the matrix is a sum of products of
/// one-dimensional ones, stiffness K along one axis times mass M along the other. With K w = lambda M w on each axis,
///
/// @f[ (K_x \otimes M_y + M_x \otimes K_y)^{-1} = (W_x \otimes W_y) (\Lambda_x + \Lambda_y)^{-1} (W_x \otimes W_y)^T
/// @f]
///
/// Walls and periods are those of the lattice; free ends are natural. The inverse, cut down to the functions of the
/// water, belongs to the least energy with which their spline is continued over the rectangle: that is equivalent to
/// the energy in the water alone, whatever the cells, so that the number of iterations hardly depends on these.
///
/// Applying it costs 4 n (columns + rows) operations for n functions of the rectangle, in single precision.
///
/// When not to use it: water that fills a small part of its rectangle.
///
/// References: Lynch, Rice & Thomas, Direct solution of partial difference equations by tensor product methods, Numer.
/// Math. 6 (1964) 185; Nepomnyaschikh, Method of splitting into subspaces for solving elliptic boundary value problems
/// in complex-form domains, Sov. J. Numer. Anal. Math. Modelling 6 (1991) 151.
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "seiche/models/gauss_particles/lattice.hpp"

namespace seiche::gauss_particles {

class LatticePreconditioner {
 public:
  /// Functions first ... first + count - 1 of an axis.
  struct Range {
    long first = 0;
    long count = 0;
  };
  /// @param columns, rows  functions along x and y that make the rectangle
  LatticePreconditioner(const Lattice& lattice, Range columns, Range rows);

  /// Replaces the loads of the rectangle's functions, row by row within columns, by coefficients.
  /// @param magnitude  typical size of the loads, which are divided by it: single precision ends at 1e-38
  void apply(std::span<double> values, double magnitude);

 private:
  using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix along_x_, along_y_;  // eigenvectors in columns
  Matrix inverse_;            // of the sum of the eigenvalues
  Matrix values_, modes_, half_;
};

}  // namespace seiche::gauss_particles
