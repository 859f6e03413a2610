#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include "reports/evidence/claim.hpp"
#include "reports/evidence/order_of_few.hpp"

namespace seiche::evidence {

ObservedOrder observed_order(const std::vector<double>& sizes, const std::vector<double>& errors, double floor) {
  return order_of_few(sizes, errors, 4, floor);
}

ObservedOrder order_of_few(const std::vector<double>& sizes, const std::vector<double>& errors, std::size_t fewest,
                           double floor) {
  if (fewest < 3) throw std::invalid_argument(fmt::format("observed order: fewest = {}, must be at least 3", fewest));
  if (sizes.size() != errors.size() || sizes.empty()) {
    throw std::invalid_argument(fmt::format("observed order: {} sizes and {} errors, must be equally many and not none",
                                            sizes.size(), errors.size()));
  }
  ObservedOrder result;
  std::vector<double> log_size;
  std::vector<double> log_error;
  std::vector<std::string> left_out;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (!(std::isfinite(sizes[k]) && sizes[k] > 0)) {
      throw std::invalid_argument(fmt::format("observed order: size = {:g}, must be positive and finite", sizes[k]));
    }
    if (!std::isfinite(errors[k]) || errors[k] < 0) {
      return {.sizes = sizes,
              .errors = errors,
              .note = fmt::format("the error at size {:g} is not a finite number", sizes[k])};
    }
    if (errors[k] <= floor || errors[k] == 0) {
      left_out.push_back(fmt::format("{:g}", sizes[k]));
      continue;
    }
    result.sizes.push_back(sizes[k]);
    result.errors.push_back(errors[k]);
    log_size.push_back(std::log(sizes[k]));
    log_error.push_back(std::log(errors[k]));
  }
  if (!left_out.empty()) {
    result.note = fmt::format("at the round-off floor {:.2g}, left out: size {}", floor, fmt::join(left_out, ", "));
  }
  if (result.sizes.size() < fewest) {
    result.note += fmt::format("{}only {} usable resolutions, {} are needed", result.note.empty() ? "" : "; ",
                               result.sizes.size(), fewest == 3 ? "three" : "four");
    return result;
  }

  double intercept = 0;
  double slope = 0;
  double cov_intercept = 0;
  double cov_mixed = 0;
  double cov_slope = 0;
  double residual = 0;
  const std::size_t n = log_size.size();
  gsl_fit_linear(log_size.data(), 1, log_error.data(), 1, n, &intercept, &slope, &cov_intercept, &cov_mixed, &cov_slope,
                 &residual);
  result.order = slope;

  // error = a h^p (1 + c h): h/h_max beside log h, whose share of it a line through the logarithms takes already.
  const double largest = *std::max_element(result.sizes.begin(), result.sizes.end());
  double level = 0;
  double share = 0;
  std::vector<double> next;
  for (const double size : result.sizes) next.push_back(size / largest);
  double unused = 0;
  gsl_fit_linear(log_size.data(), 1, next.data(), 1, n, &level, &share, &unused, &unused, &unused, &unused);
  double product = 0;
  double squares = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double rest = next[k] - level - share * log_size[k];
    product += rest * log_error[k];
    squares += rest * rest;
  }
  result.half_width = gsl_cdf_tdist_Pinv(0.975, static_cast<double>(n - 2)) * std::sqrt(cov_slope) +
                      std::abs(share * product / squares);
  return result;
}

}  // namespace seiche::evidence
