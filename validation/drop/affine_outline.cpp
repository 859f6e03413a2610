#include "validation/drop/affine_outline.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace seiche::validation {

void draw_outline(evidence::Panel& panel, const exact::AffineDrop& drop, double time) {
  std::vector<double> x, y;
  const Eigen::Matrix2d deformation = drop.at(time).deformation;
  for (int k = 0; k <= 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200;
    const Eigen::Vector2d place = deformation * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    x.push_back(place.x());
    y.push_back(place.y());
  }
  panel.line("exact", x, y, evidence::Role::exact);
}

}  // namespace seiche::validation
