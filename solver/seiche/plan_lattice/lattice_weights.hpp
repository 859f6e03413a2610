/// Weights of a row's neighbouring nodes in the polynomial through them, and the weights' derivatives.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace seiche::plan_lattice {

struct LatticeWeights {
  std::size_t first = 0;  ///< of the nodes
  std::size_t count = 0;
  std::array<double, 4> weight{}, slope{};
};

/// Through the four nodes around a place counted in cells, of a row with at least three; beyond its ends through the
/// outermost.
inline LatticeWeights cubic_weights(double at, std::size_t cells) {
  const double cell = std::clamp(std::floor(at), 0.0, static_cast<double>(cells) - 1);
  const double first = std::clamp(cell - 1, 0.0, static_cast<double>(cells) - 3);
  LatticeWeights w{.first = static_cast<std::size_t>(first), .count = 4};
  const double a = at - first;
  const double b = a - 1;
  const double c = a - 2;
  const double d = a - 3;
  w.weight = {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
  w.slope = {-(c * d + b * d + b * c) / 6, (c * d + a * d + a * c) / 2, -(b * d + a * d + a * b) / 2,
             (b * c + a * c + a * b) / 6};
  return w;
}

/// Through the two nodes of a cell.
inline LatticeWeights linear_weights(double at, std::size_t cells) {
  const double first = std::clamp(std::floor(at), 0.0, static_cast<double>(cells) - 1);
  LatticeWeights w{.first = static_cast<std::size_t>(first), .count = 2};
  w.weight = {1 - (at - first), at - first};
  w.slope = {-1, 1};
  return w;
}

}  // namespace seiche::plan_lattice
