/// Bars on the bottom of water whose period is 2 pi, by a conformal map: z = zeta + i b exp(i n (zeta + i h)) takes the
/// water over the level bottom Im zeta = -h to that over the trochoid
///
///     x = s - b sin ns,   y = -h + b cos ns,
///
/// n bars to a period with a crest at x = 0, sharper than the troughs. A potential phi(zeta) is one of z too, with the
/// velocity dw/dz = (dw/dzeta)/(dz/dzeta): water over bars moves as over a level bottom but for that factor, and for
/// the height Im z that its weight has.
///
/// When not to use it: other bottoms; bars with n b near 1, whose crests are cusps.
#pragma once

#include <cmath>
#include <complex>
#include <limits>

namespace seiche::exact::overturning {

struct Bars {
  using Complex = std::complex<double>;

  double half_height = 0;                                  ///< b, n b < 1; 0: none
  double number = 1;                                       ///< n
  double depth = std::numeric_limits<double>::infinity();  ///< h

  /// z - zeta.
  [[nodiscard]] Complex offset(Complex zeta) const {
    return half_height == 0 ? 0 : Complex(0, half_height) * std::exp(Complex(0, number) * (zeta + Complex(0, depth)));
  }
  /// dz/dzeta.
  [[nodiscard]] Complex slope(Complex zeta) const { return 1.0 + Complex(0, number) * offset(zeta); }
  /// zeta of a place in the water, by Newton's iteration.
  [[nodiscard]] Complex origin(Complex z) const {
    Complex zeta = z;
    for (int i = 0; half_height != 0 && i < 8; ++i) zeta -= (zeta + offset(zeta) - z) / slope(zeta);
    return zeta;
  }

  /// Elevation, slope and second derivative of the bottom under x, also where there are no bars.
  struct Bottom {
    double elevation, slope, curvature;
  };
  [[nodiscard]] Bottom bottom(double x) const {
    Complex zeta(x, -depth);
    for (int i = 0; i < 8; ++i) zeta -= ((zeta + offset(zeta)).real() - x) / slope(zeta).real();
    const Complex rate = slope(zeta), bend = -number * number * offset(zeta);
    const double across = rate.real();
    return {offset(zeta).imag() - depth, rate.imag() / across,
            (bend.imag() * across - rate.imag() * bend.real()) / (across * across * across)};
  }
};

}  // namespace seiche::exact::overturning
