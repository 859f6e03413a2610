#include "seiche/exact/slope_climb/chebyshev_line.hpp"

#include <cmath>
#include <numbers>

namespace seiche::exact::slope_climb {
namespace {

using Eigen::Index;

/// T_c at the r-th of the nodes of so many intervals; the argument stays small, as does its rounding.
double polynomial(Index c, Index r, Index intervals) {
  const Index phase = ((intervals - r) * c) % (2 * intervals);
  return std::cos(std::numbers::pi * static_cast<double>(phase) / static_cast<double>(intervals));
}

double halved_at_ends(Index k, Index n) {
  return k == 0 || k == n ? 0.5 : 1;
}

}  // namespace

Eigen::VectorXd clenshaw_curtis(std::size_t intervals) {
  const auto n = static_cast<Index>(intervals);
  Eigen::VectorXd weights(n + 1);
  for (Index r = 0; r <= n; ++r) {
    double sum = 0;
    for (Index c = 0; c <= n; c += 2) {
      sum += halved_at_ends(c, n) * polynomial(c, r, n) * 2 / (1 - static_cast<double>(c * c));
    }
    weights[r] = 2 * halved_at_ends(r, n) * sum / static_cast<double>(n);
  }
  return weights;
}

ChebyshevLine::ChebyshevLine(std::size_t intervals)
    : n_(intervals), nodes_(static_cast<Index>(intervals) + 1), weights_(clenshaw_curtis(intervals)) {
  const auto n = static_cast<Index>(n_);
  for (Index r = 0; r <= n; ++r) nodes_[r] = polynomial(1, r, n);
  derivative_.setZero(n + 1, n + 1);
  const double step = std::numbers::pi / (2 * static_cast<double>(n));
  for (Index r = 0; r <= n; ++r) {
    for (Index c = 0; c <= n; ++c) {
      if (r == c) continue;
      // s_r - s_c by sines, to the last digit.
      const double apart =
          2 * std::sin(step * static_cast<double>(r + c)) * std::sin(step * static_cast<double>(r - c));
      const double sign = (r + c) % 2 == 0 ? 1 : -1;
      derivative_(r, c) = sign * halved_at_ends(c, n) / (halved_at_ends(r, n) * apart);
    }
    derivative_(r, r) = -derivative_.row(r).sum();
  }
  Eigen::VectorXd kept(n + 1);
  for (Index k = 0; k <= n; ++k)
    kept[k] = std::exp(-36 * std::pow(static_cast<double>(k) / static_cast<double>(n), 24));
  Eigen::MatrixXd values(n + 1, n + 1);
  for (Index c = 0; c <= n; ++c) {
    for (Index r = 0; r <= n; ++r) values(r, c) = polynomial(c, r, n);
  }
  filter_ = values * kept.asDiagonal() * coefficients();
}

Eigen::MatrixXd ChebyshevLine::coefficients() const {
  const auto n = static_cast<Index>(n_);
  Eigen::MatrixXd matrix(n + 1, n + 1);
  for (Index r = 0; r <= n; ++r) {
    for (Index c = 0; c <= n; ++c) {
      matrix(c, r) = 2 * halved_at_ends(c, n) * halved_at_ends(r, n) * polynomial(c, r, n) / static_cast<double>(n);
    }
  }
  return matrix;
}

Eigen::MatrixXd ChebyshevLine::refinement(std::size_t times) const {
  const auto n = static_cast<Index>(n_);
  const Index fine = n * static_cast<Index>(times);
  Eigen::MatrixXd values(fine + 1, n + 1);
  for (Index c = 0; c <= n; ++c) {
    for (Index r = 0; r <= fine; ++r) values(r, c) = polynomial(c, r, fine);
  }
  return values * coefficients();
}

}  // namespace seiche::exact::slope_climb
