#include "seiche/linear/layered_lattice.hpp"

#include <cmath>

#include "seiche/require.hpp"

namespace seiche::linear {

LayeredLattice::LayeredLattice(double column_width, std::vector<double> row_heights, double density)
    : column_width_(column_width), row_heights_(std::move(row_heights)) {
  require_positive("column_width", column_width);
  require_positive("density", density);
  require_at_least("row_heights.size()", static_cast<long>(row_heights_.size()), 1);
  double below = 0;
  for (const double height : row_heights_) {
    require_positive("row_height", height);
    mobility_.push_back(2 / (density * column_width * (below + height)));
    below = height;
  }
  mobility_.push_back(2 / (density * column_width * below));
}

void LayeredLattice::operator()(double theta, double /*psi*/, std::span<double> diagonal,
                                std::span<double> off_diagonal) const {
  const double sine = std::sin(theta / 2);
  const double cosine = std::cos(theta / 2);
  const double horizontal = sine * sine;
  const double vertical = cosine * cosine * column_width_ * column_width_;
  for (std::size_t j = 0; j < row_heights_.size(); ++j) {
    const double h = row_heights_[j];
    const double bottom = j == 0 ? 0 : mobility_[j];  // vertical mobility of the lower nodes
    const double top = mobility_[j + 1];
    diagonal[j] = horizontal * h * h * (mobility_[j] + top) + vertical * (bottom + top);
    if (j + 1 < row_heights_.size()) off_diagonal[j] = (horizontal * h * row_heights_[j + 1] - vertical) * top;
  }
}

}  // namespace seiche::linear
