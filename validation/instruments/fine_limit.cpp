#include "validation/instruments/fine_limit.hpp"

#include <cmath>
#include <stdexcept>

#include "reports/evidence/grid_convergence.hpp"

namespace seiche::validation {

FineLimit fine_limit(const std::vector<double>& sizes, const std::vector<double>& values, double order) {
  if (sizes.size() < 2 || values.size() != sizes.size()) {
    throw std::invalid_argument("the limit of fine grids needs two grids or more");
  }
  if (sizes.size() > 2) {
    const evidence::GridConvergence fit = evidence::grid_convergence(sizes, values, order);
    return {fit.extrapolated, fit.uncertainty};
  }
  const double rest = (values[1] - values[0]) / (std::pow(sizes[1] / sizes[0], order) - 1);
  return {values[0] - rest, 3 * std::abs(rest)};
}

}  // namespace seiche::validation
