/// A plane wave exp(i k . r) on a rectangular plan lattice of bilinear cells: what differencing, averaging and the
/// potential energy of the surface make of it.
///
///     mean      c1 c2                                    average over the corners of a cell
///     gradient  2 |(s1 c2/h1, s2 c1/h2)| = K c1 c2       difference of opposite sides, averaged along them
///     potential G = ((2 + cos k1 h1)/3) ((2 + cos k2 h2)/3)   mean square of the bilinear patches over that of the
///                                                        corners
///
/// c_i = cos(k_i h_i/2), s_i = sin(k_i h_i/2), K^2 = T1^2 + T2^2, T_i = (2/h_i) tan(k_i h_i/2): the wavenumber that the
/// constraint of a cell sees. mean and gradient stay finite where K does not, k_i h_i = pi.
#pragma once

namespace seiche::exact {

struct PlanSymbol {
  double mean;
  double gradient;  ///< [1/m]
  double potential;
};

/// @param kx, ky  wavenumber [1/m], not both 0, |k_i| h_i <= pi;  @param hx, hy  sides of a cell h1, h2 [m]
/// Throws std::invalid_argument.
PlanSymbol plan_symbol(double kx, double ky, double hx, double hy);

}  // namespace seiche::exact
