/// Where a smooth quantity is largest along a family of waves.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <utility>

#include "seiche/exact/entry.hpp"

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
  const double top = exact::root([&](double t) { return polynomial(t, 1); }, -1, 1);
  return {middle + reach * spacing * top, polynomial(top, 0)};
}

}  // namespace seiche::verification
