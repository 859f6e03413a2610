/// Sums of a smoothing kernel over an unbounded lattice of particles, about one of them.
///
///     zeroth   S0 = sum V W,               self term included, 1 in the limit of many neighbours
///     first    M  = -sum V x dW/dx,        what the uncorrected first derivative multiplies a linear field by
///     laminar  N  = -1/2 sum V r^3 W'/(r^2 + 0.01 h^2),  the same of the laminar operator and a parabola
///     symbol   S(k) = -sum V sin(k x) dW/dx,             that of the derivative of a wave along x; S/k -> M as k -> 0
///
/// References: Quinlan, Basa and Lastiwka, Truncation error in mesh-free particle methods, Int. J. Numer. Meth. Eng. 66
/// (2006) 2064; Morris, A study of the stability properties of smooth particle hydrodynamics, PASA 13 (1996) 97.
#pragma once

#include <cmath>

#include "seiche/models/wcsph/kernel.hpp"

namespace seiche::verification {

/// One particle per cell of side 1, or two.
enum class Arrangement { square, body_centred };

struct LatticeSums {
  double zeroth = 0, first = 0, laminar = 0, symbol = 0;
  int neighbours = 0;
};

/// @param h           smoothing length over the side of a cell
/// @param wavenumber  k times the side of a cell
template <class Kernel>
LatticeSums lattice_sums(double h, Arrangement arrangement = Arrangement::square, double wavenumber = 0) {
  LatticeSums sums;
  const double volume = arrangement == Arrangement::square ? 1 : 0.5;
  const auto add = [&](double x, double z) {
    const double r = std::hypot(x, z);
    if (r >= wcsph::support * h) return;
    sums.zeroth += volume * wcsph::weight<Kernel>(r, h);
    if (r == 0) return;
    const double slope = wcsph::radial_slope<Kernel>(r, h);
    sums.first -= volume * x * x / r * slope;
    sums.laminar -= 0.5 * volume * r * r * r * slope / (r * r + 0.01 * h * h);
    sums.symbol -= volume * std::sin(wavenumber * x) * x / r * slope;
    ++sums.neighbours;
  };
  const int reach = static_cast<int>(std::ceil(wcsph::support * h)) + 1;
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      add(i, j);
      if (arrangement == Arrangement::body_centred) add(i + 0.5, j + 0.5);
    }
  }
  return sums;
}

}  // namespace seiche::verification
