/// The penalty on gradients of vorticity that holds down the quadrature instability under gravity.
///
/// Sums over particles are no exact integrals: gravity does work on eddies of the lattice's size as if they had a small
/// negative potential energy, and they grow although the total energy is exact. The penalty adds, in the norm that the
/// projection minimises,
///
/// @f[ \frac{\tau}{2} \nu_4 \sum_c \min(1, M_c/(\rho h^2)) \, \rho \int_c |\nabla \Delta \Phi|^2, \qquad
///     \nu_4 = C h^{7/2} g^{1/2} @f]
///
/// over the occupied cells c. It vanishes for irrotational and for linear velocity fields, so that momenta stay exact;
/// the energy it takes is tau nu_4 times the form, known to round-off. Over uneven ground it is taken in (x, eta).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/gauss_particles/lattice.hpp"

namespace seiche::gauss_particles {

class VorticityPenalty {
 public:
  /// Computes again what depends on the cells, when they changed.
  void prepare(const Lattice& lattice);
  /// The integral of grad lap Phi_a . grad lap Phi_b over a full cell, (p + 1)^2 by (p + 1)^2.
  [[nodiscard]] std::span<const double> matrix(std::size_t kind_x, std::size_t kind_y);

 private:
  int degree_ = 0;
  double cell_x_ = 0;
  double cell_y_ = 0;
  std::vector<std::vector<double>> matrices_;  // of pairs of kinds; empty until asked for
};

}  // namespace seiche::gauss_particles
