#include "seiche/exact/exponential_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace seiche::exact {
namespace {

using Order = ExponentialSum::Order;
using Triple = ExponentialSum::Triple;

double power(double base, int exponent) {
  double product = 1;
  for (int k = 0; k < exponent; ++k) product *= base;
  return product;
}

double binomial(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

/// The rates of the terms as a random variable.
struct Distribution {
  std::vector<double> weights;
  std::vector<Triple> deviations;  ///< from the mean
  Triple mean;

  [[nodiscard]] double moment(const Order& order) const {
    double sum = 0;
    for (std::size_t m = 0; m < weights.size(); ++m) {
      sum += weights[m] * power(deviations[m][0], order[0]) * power(deviations[m][1], order[1]) *
             power(deviations[m][2], order[2]);
    }
    return sum;
  }

  /// Of the deviations:  d^(a+i) F = moment(a+i) - sum over b < a of (a over b) moment(a-b) d^(b+i) F.
  [[nodiscard]] double cumulant(const Order& order) const {
    if (order[0] + order[1] + order[2] == 1) return 0;
    const auto i =
        static_cast<std::size_t>(std::find_if(order.begin(), order.end(), [](int n) { return n > 0; }) - order.begin());
    Order rest = order;
    --rest[i];
    double value = moment(order);
    for (int a = 0; a <= rest[0]; ++a) {
      for (int b = 0; b <= rest[1]; ++b) {
        for (int c = 0; c <= rest[2]; ++c) {
          Order lower{a, b, c};
          const Order remaining{rest[0] - a, rest[1] - b, rest[2] - c};
          // The mean of the deviations is 0: neither a first cumulant nor a first moment contributes.
          if (a + b + c == 0 || remaining[0] + remaining[1] + remaining[2] < 2) continue;
          ++lower[i];
          value -=
              binomial(rest[0], a) * binomial(rest[1], b) * binomial(rest[2], c) * moment(remaining) * cumulant(lower);
        }
      }
    }
    return value;
  }
};

Distribution distribution_of(const std::vector<ExponentialSum::Term>& terms, const Triple& at) {
  Distribution result;
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& term : terms) {
    const double exponent = term.rate[0] * at[0] + term.rate[1] * at[1] + term.rate[2] * at[2] + term.constant;
    result.weights.push_back(exponent);
    largest = std::max(largest, exponent);
  }
  double sum = 0;
  for (double& weight : result.weights) sum += weight = std::exp(weight - largest);
  for (double& weight : result.weights) weight /= sum;
  for (std::size_t i = 0; i < 3; ++i) {
    result.mean[i] = 0;
    for (std::size_t m = 0; m < terms.size(); ++m) result.mean[i] += result.weights[m] * terms[m].rate[i];
  }
  for (const auto& term : terms) {
    Triple& deviation = result.deviations.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) deviation[i] = term.rate[i] - result.mean[i];
  }
  return result;
}

}  // namespace

double ExponentialSum::log_derivative(const Triple& at, const Order& order) const {
  const Distribution distribution = distribution_of(terms_, at);
  for (std::size_t i = 0; i < 3; ++i) {
    if (order[i] == 1 && order[0] + order[1] + order[2] == 1) return distribution.mean[i];
  }
  return distribution.cumulant(order);
}

}  // namespace seiche::exact
