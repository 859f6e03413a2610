// Splines of free particles: polynomials are reproduced, and continued, to round-off on every kind of axis.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/models/gauss_particles/lattice.hpp"
#include "seiche/samples.hpp"
#include "verification/check.hpp"

namespace seiche::verification::gauss_particles_splines_test {

using namespace gauss_particles;

/// Coefficients of place^power, counted in cells from `middle`, by Marsden's identity; functions are taken 2^p p!
/// times.
double marsden(const SplineAxis& axis, long function, int power, double middle) {
  const int p = axis.degree();
  std::vector<double> symmetric(static_cast<std::size_t>(p) + 1, 0.0);
  symmetric[0] = 1;
  for (int k = 1; k <= p; ++k) {
    for (int a = p; a > 0; --a) {
      symmetric[static_cast<std::size_t>(a)] +=
          (axis.knot(function + k) - middle) * symmetric[static_cast<std::size_t>(a) - 1];
    }
  }
  double binomial = 1, factor = 1;
  for (int k = 1; k <= power; ++k) binomial *= static_cast<double>(p - k + 1) / k;
  for (int k = 1; k <= p; ++k) factor *= 2.0 * k;
  return symmetric[static_cast<std::size_t>(power)] / (binomial * factor);
}

struct Defects {
  double reproduced, continued;
};

Defects defects(int degree, Ends ends) {
  constexpr long cells = 14;
  const SplineAxis axis(degree, 0, 1, cells, ends);
  Worst reproduced, continued;
  const auto order = static_cast<std::size_t>(degree) + 1;
  for (int power = 0; power <= degree; ++power) {
    for (long c = 0; c < cells; ++c) {
      const double middle = static_cast<double>(c) + 0.5;
      const CellPolynomials& splines = cell_polynomials(degree)[axis.kind(c)];
      for (const double z : {-0.5, -0.2, 0.1, 0.5}) {
        double sum = 0;
        for (std::size_t i = 0; i < order; ++i) {
          double value = 0;
          for (std::size_t a = order; a-- > 0;) value = value * z + splines.function[i * order + a];
          sum += marsden(axis, c + static_cast<long>(i), power, middle) * value;
        }
        reproduced.add(sum - std::pow(z, power));
      }
    }
    if (ends == Ends::periodic) continue;
    for (const std::size_t side : {order, std::size_t{3}}) {
      if (power >= static_cast<int>(side)) continue;
      std::vector<double> weights(side);
      for (long i = 0; i < axis.functions(); ++i) {
        for (long i0 = 0; i0 + static_cast<long>(side) <= axis.functions() && i0 < cells; ++i0) {
          const double away = std::abs(static_cast<double>(i - i0));
          if (away > 7) continue;
          const auto middle = static_cast<double>(i0);
          axis.extend(i, i0, weights);
          double sum = 0, size = 1;
          for (std::size_t a = 0; a < side; ++a) {
            const double term = weights[a] * marsden(axis, i0 + static_cast<long>(a), power, middle);
            sum += term;
            size += std::abs(term);
          }
          continued.add((sum - marsden(axis, i, power, middle)) / size);
        }
      }
    }
  }
  return {reproduced.value(), continued.value()};
}

TEST_CASE("splines reproduce and continue polynomials to round-off", "[geometry]") {
  Check check("gauss_particles_splines", "Splines of Gauss-principle particles: polynomials",
              "Sums of B-splines with Marsden's coefficients are the powers of the coordinate, in every cell of axes "
              "with free ends, with walls, and without ends. The coefficient of a function up to seven cells away "
              "follows from degree + 1 neighbours, or of three for polynomials of degree 2.");
  const std::vector<std::pair<Ends, std::string>> all{
      {Ends::free, "free"}, {Ends::wall_below, "wall_below"}, {Ends::walls, "walls"}, {Ends::periodic, "periodic"}};
  for (int degree = lowest_degree; degree <= highest_degree; ++degree) {
    for (const auto& [ends, name] : all) {
      const Defects d = defects(degree, ends);
      const std::string polynomials = fmt::format("Degree {}, {}: polynomials are ", degree, name);
      check.holds(polynomials + "reproduced.", {d.reproduced},
                  Roundoff{100, 4, "some 16 products, of powers of positions up to (degree + 1)/2 cells"});
      if (ends == Ends::periodic) continue;
      check.holds(polynomials + "continued.", {d.continued},
                  Roundoff{400, 4, "relative to the terms of the sum; weights from a triangle of 10 quotients"});
    }
  }
}

}  // namespace seiche::verification::gauss_particles_splines_test
