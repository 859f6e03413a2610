/// The sums over the particles of one cell: mass matrix, load, and the velocity field at the particles.
///
/// In a cell every spline is a polynomial. Sums over particles are taken of powers of the place (moments), and what is
/// asked of pairs of functions is read off these: (2 p + 1)^2 numbers per particle instead of (p + 1)^4.
///
/// With the stream function Phi(x, eta) the velocity is (Phi_eta, -Phi_x + b' Phi_eta). Functions of a cell are
/// numbered i (p + 1) + j, i along x.
#pragma once

#include <cstddef>

#include "seiche/models/gauss_particles/lattice.hpp"

namespace seiche::gauss_particles {

/// The places of one cell in the arrays of OccupiedCells; a multiple of OccupiedCells::lanes of them.
struct CellParticles {
  std::size_t count = 0;
  const double* across = nullptr;
  const double* up = nullptr;
  const double* mass = nullptr;
  const double* slope = nullptr;  ///< b'; none over level ground
};

/// The splines of one cell.
struct CellSplines {
  const CellPolynomials* x = nullptr;
  const CellPolynomials* y = nullptr;
  double cell_x = 1;  ///< [m]
  double cell_y = 1;  ///< [m]
};

struct CellKernels {
  static constexpr std::size_t most_functions = CellPolynomials::most * CellPolynomials::most;

  /// matrix[a][b] = sum of m v_a . v_b over the particles, (p + 1)^2 by (p + 1)^2.
  void (*mass_matrix)(const CellParticles& at, const CellSplines& splines, double* matrix);
  /// load[a] = sum of m w . v_a over the particles; w = (wx, wy) place by place.
  void (*load)(const CellParticles& at, const CellSplines& splines, const double* wx, const double* wy, double* load);
  /// (ux, uy) = the field of these coefficients at the particles.
  void (*velocity)(const CellParticles& at, const CellSplines& splines, const double* coefficients, double* ux,
                   double* uy);
};

/// @param degree  2, 3 or 4. @param uneven  whether slopes are given
const CellKernels& cell_kernels(int degree, bool uneven);

}  // namespace seiche::gauss_particles
