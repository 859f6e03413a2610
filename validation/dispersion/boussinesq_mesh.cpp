#include "validation/dispersion/boussinesq_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/tools/minima.hpp>

#include "seiche/exact/dispersion.hpp"
#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_case.hpp"

namespace seiche::validation {

double distance_from_boussinesq(double column_width, std::size_t rows) {
  const exact::LagrangianMeshDispersion law(1, 1, column_width, rows);
  const auto boussinesq = exact::RationalDispersion::green_naghdi(1, 1);
  Worst difference;
  for (const double k : evenly(0.01, 2 * std::numbers::pi / shortest_like_boussinesq, 300)) {
    difference.add(law.frequency(k) / boussinesq.frequency(k) - 1, k);
  }
  return difference.value();
}

double boussinesq_width(std::size_t rows) {
  const auto distance = [&](double width) { return distance_from_boussinesq(width, rows); };
  const std::vector<double> widths = evenly(0.02, 1.7, 85);
  const double near =
      *std::min_element(widths.begin(), widths.end(), [&](double a, double b) { return distance(a) < distance(b); });
  const double reach = widths[1] - widths[0];
  constexpr int bits = 26;
  return boost::math::tools::brent_find_minima(distance, std::max(0.001, near - reach), near + reach, bits).first;
}

}  // namespace seiche::validation
