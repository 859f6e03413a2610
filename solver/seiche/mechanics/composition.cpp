#include "seiche/mechanics/composition.hpp"

#include <cmath>

namespace seiche::mechanics {

namespace {

std::vector<double> staged(const std::vector<double>& weights, Stages stages) {
  if (stages == Stages::single) return weights;
  std::vector<double> halves;
  for (const double weight : weights) halves.insert(halves.end(), 2, weight / 2);
  return halves;
}

}  // namespace

std::vector<double> triple_jump_weights(Stages stages) {
  const double g = 1 / (2 - std::cbrt(2.0));
  return staged({g, 1 - 2 * g, g}, stages);
}

std::vector<double> suzuki_weights(Stages stages) {
  const double g = 1 / (4 - std::cbrt(4.0));
  return staged({g, g, 1 - 4 * g, g, g}, stages);
}

}  // namespace seiche::mechanics
