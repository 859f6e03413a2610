/// Row by row, the matrix and the right-hand side of the integral equation in surface_velocity.hpp: additions,
/// multiplications and one division per pair of markers.
///
/// With E = exp(iz) and e = exp(i z - h) of every marker,
///
///     (1/2) cot((z_j - z_i)/2)                 =  i/2 + i E_i/(E_j - E_i),
///     (1/2) cot((conj z_j - 2ih - z_i)/2)      = -i/2 + i/(1 - e_i conj e_j)
///
/// so that a row needs sums of 1/(E_j - E_i) and 1/(1 - e_i conj e_j) only.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace seiche::exact::overturning {

/// Real and imaginary parts apart: the loops load both with unit stride.
struct Complexes {
  std::vector<double> re;
  std::vector<double> im;

  explicit Complexes(std::size_t n) : re(n), im(n) {}
  [[nodiscard]] std::complex<double> operator[](std::size_t i) const { return {re[i], im[i]}; }
  void set(std::size_t i, std::complex<double> value) {
    re[i] = value.real();
    im[i] = value.imag();
  }
};

/// Sums over the markers j of row i, j = i left out.
struct RowSums {
  std::complex<double> direct;  ///< sum phi_s,j/(E_j - E_i)
  std::complex<double> image;   ///< sum phi_s,j/(1 - e_i conj e_j)
  double product = 0;           ///< sum A_ij x_j, in double precision
};

/// Row i of A without its diagonal: A_ij = factor Re[z_s E_i/(E_j - E_i) + z_s/(1 - e_i conj e_j)], z_s that of marker
/// i.
///
/// @param e    of every marker; nullptr for infinite depth, where it is zero
/// @param row  receives A_ij, in single precision
RowSums kernel_row(std::size_t i, std::complex<double> z_s, double factor, const Complexes& E, const Complexes* e,
                   const double* phi_s, const double* x, std::vector<float>::iterator row);

/// y = x - A x with A stored by rows.
void subtract_product(const std::vector<float>& A, const double* x, double* y, std::size_t n);

}  // namespace seiche::exact::overturning
