/// Where a smooth quantity is largest along a family of waves.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <utility>

namespace seiche::verification {

/// Place and value of the maximum of the polynomial through nine waves around `middle`, `spacing` apart.
inline std::pair<double, double> wave_maximum(const std::function<double(double)>& quantity, double middle,
                                              double spacing) {
  constexpr int reach = 4;
  constexpr int count = 2 * reach + 1;
  Eigen::Matrix<double, count, count> powers;
  Eigen::Matrix<double, count, 1> values;
  for (int k = 0; k < count; ++k) {
    const double t = static_cast<double>(k - reach) / reach;
    for (int p = 0; p < count; ++p) powers(k, p) = std::pow(t, p);
    values[k] = quantity(middle + reach * spacing * t);
  }
  const Eigen::Matrix<double, count, 1> coefficients = powers.fullPivLu().solve(values);
  const auto polynomial = [&](double t, int derivative) {
    double sum = 0;
    for (int p = count - 1; p >= derivative; --p) sum = sum * t + (derivative == 0 ? 1 : p) * coefficients[p];
    return sum;
  };
  // The root of the derivative: the quantity itself is flat to round-off over a width of its square root.
  double low = -1;
  double high = 1;
  for (int step = 0; step < 60; ++step) {
    const double centre = 0.5 * (low + high);
    (polynomial(centre, 1) > 0 ? low : high) = centre;
  }
  return {middle + reach * spacing * low, polynomial(low, 0)};
}

}  // namespace seiche::verification
