#include "reports/evidence/grid_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

namespace seiche::evidence {
namespace {

struct Fit {
  double extrapolated = 0;
  double scatter = 0;  ///< standard deviation of the residuals
};

/// Least squares of value = extrapolated + a h^p for a given p.
Fit fit_with_order(const std::vector<double>& sizes, const std::vector<double>& values, double p) {
  std::vector<double> power(sizes.size());
  std::transform(sizes.begin(), sizes.end(), power.begin(), [p](double h) { return std::pow(h, p); });
  double intercept = 0;
  double slope = 0;
  double c00 = 0;
  double c01 = 0;
  double c11 = 0;
  double squares = 0;
  gsl_fit_linear(power.data(), 1, values.data(), 1, values.size(), &intercept, &slope, &c00, &c01, &c11, &squares);
  const double freedom = std::max(1.0, static_cast<double>(values.size()) - 3);
  return {intercept, std::sqrt(squares / freedom)};
}

}  // namespace

GridConvergence grid_convergence(const std::vector<double>& sizes, const std::vector<double>& values, double theory) {
  const bool positive = std::all_of(sizes.begin(), sizes.end(), [](double h) { return std::isfinite(h) && h > 0; });
  if (sizes.size() != values.size() || std::set<double>(sizes.begin(), sizes.end()).size() < 3 || !positive) {
    throw std::invalid_argument(
        fmt::format("grid convergence: needs three or more different positive sizes with as many values, got {} and {}",
                    sizes.size(), values.size()));
  }
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    return {nothing, nothing, nothing, "a value is not a finite number"};
  }
  const auto finest = static_cast<std::size_t>(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (*low == *high) return {*low, theory, 0, "no change with resolution"};

  // The residual of the fit is a smooth function of p with one minimum in practice; a scan is robust where values
  // oscillate and Newton would not be.
  constexpr double lowest_order = 0.1;
  constexpr double highest_order = 8;
  constexpr int samples = 1581;  // steps of 0.005
  double best_order = lowest_order;
  double best_scatter = std::numeric_limits<double>::infinity();
  for (int k = 0; k < samples; ++k) {
    const double p = lowest_order + (highest_order - lowest_order) * k / (samples - 1);
    const double scatter = fit_with_order(sizes, values, p).scatter;
    if (scatter < best_scatter) {
      best_scatter = scatter;
      best_order = p;
    }
  }

  GridConvergence result;
  const bool trusted = best_order >= 0.5 && best_order <= theory + 0.5;
  result.order = std::clamp(best_order, 0.5, theory);
  const Fit fit = fit_with_order(sizes, values, result.order);
  result.extrapolated = fit.extrapolated;
  const double safety = trusted ? 1.25 : 3.0;
  result.uncertainty = safety * std::abs(values[finest] - fit.extrapolated) + 2 * fit.scatter;
  if (!trusted) {
    result.note = fmt::format("observed order {:.2f} outside [0.5, {:.2f}]: safety factor 3", best_order, theory + 0.5);
  }
  return result;
}

}  // namespace seiche::evidence
