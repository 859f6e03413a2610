/// What a few lattices say of the limit of fine ones.
#pragma once

#include <vector>

namespace seiche::validation {

struct FineLimit {
  double value = 0;
  double uncertainty = 0;  ///< half-width for the finest lattice
};

/// evidence::grid_convergence for three lattices or more; of two, the order is assumed, with the factor of safety 3
/// that Roache (1994) gives his index for two.
/// @param sizes  spacings, the finest first, at least two
/// @param order  theoretical order of the method
FineLimit fine_limit(const std::vector<double>& sizes, const std::vector<double>& values, double order = 2);

}  // namespace seiche::validation
