#include "seiche/linear/hexahedral_lattice.hpp"

#include <cmath>
#include <stdexcept>

#include "seiche/require.hpp"

namespace seiche::linear {

HexahedralLattice::HexahedralLattice(double hx, double hy, std::vector<double> layer_heights, double density,
                                     bool free_bottom)
    : hx_(hx), hy_(hy), layer_heights_(std::move(layer_heights)), free_bottom_(free_bottom) {
  require_positive("hx", hx);
  require_positive("hy", hy);
  require_positive("density", density);
  require_at_least("layers", static_cast<long>(layer_heights_.size()), 1);
  for (const double height : layer_heights_) require_positive("layer height", height);
  for (std::size_t l = 0; l <= layer_heights_.size(); ++l) {
    const double below = l > 0 ? layer_heights_[l - 1] : 0;
    const double above = l < layer_heights_.size() ? layer_heights_[l] : 0;
    mobility_.push_back(2 / (density * hx * hy * (below + above)));
  }
}

void HexahedralLattice::operator()(double theta, double psi, std::span<double> diagonal,
                                   std::span<double> off_diagonal) const {
  const double s1 = std::sin(theta / 2);
  const double c1 = std::cos(theta / 2);
  const double s2 = std::sin(psi / 2);
  const double c2 = std::cos(psi / 2);
  const auto square = [](double a) { return a * a; };
  const double horizontal = square(hy_ * s1 * c2) + square(hx_ * s2 * c1);
  const double vertical = square(hx_ * hy_ * c1 * c2);
  const std::size_t layers = layer_heights_.size();
  for (std::size_t l = 0; l < layers; ++l) {
    const double across = horizontal * square(layer_heights_[l]);
    const double bottom = l > 0 || free_bottom_ ? vertical : 0;
    diagonal[l] = mobility_[l] * (across + bottom) + mobility_[l + 1] * (across + vertical);
    if (l + 1 == layers) break;
    off_diagonal[l] = mobility_[l + 1] * (horizontal * layer_heights_[l] * layer_heights_[l + 1] - vertical);
  }
}

}  // namespace seiche::linear
