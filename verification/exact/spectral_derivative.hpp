/// Derivatives of periodic fields of manufactured solutions.
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace seiche::verification {

/// Derivative of periodic values at so many equal spacings, exact for the harmonics that the points resolve.
inline Eigen::MatrixXd spectral_derivative(Eigen::Index points, double period) {
  return Eigen::MatrixXd::NullaryExpr(points, points, [=](Eigen::Index i, Eigen::Index j) {
    if (i == j) return 0.0;
    const double sign = (i - j) % 2 == 0 ? 1 : -1;
    return sign * std::numbers::pi / period /
           std::tan(std::numbers::pi * static_cast<double>(i - j) / static_cast<double>(points));
  });
}

}  // namespace seiche::verification
