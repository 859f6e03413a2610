/// Functions on a line by their values at Chebyshev-Lobatto nodes s_k = -cos(pi k/n), k = 0 .. n: slopes, integrals,
/// values between the nodes, and a filter of the highest coefficients.
///
/// References: Trefethen, Spectral Methods in MATLAB (2000), chapters 6 and 12; Hou & Li, Computing nearly singular
/// solutions using pseudo-spectral methods, J. Comput. Phys. 226 (2007) 379 (the filter).
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace seiche::exact::slope_climb {

class ChebyshevLine {
 public:
  /// @param intervals  n, even
  explicit ChebyshevLine(std::size_t intervals);

  [[nodiscard]] const Eigen::VectorXd& nodes() const { return nodes_; }      ///< s_k, from -1 to 1
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }  ///< of int ds (Clenshaw, Curtis)
  [[nodiscard]] const Eigen::MatrixXd& differentiation() const { return derivative_; }  ///< values to d/ds
  /// Values to those without what the highest coefficients carry: the k-th times exp(-36 (k/n)^24).
  [[nodiscard]] const Eigen::MatrixXd& filter() const { return filter_; }
  /// Values to those at the nodes of a line of times as many intervals: rows times n + 1, columns n + 1.
  [[nodiscard]] Eigen::MatrixXd refinement(std::size_t times) const;

 private:
  [[nodiscard]] Eigen::MatrixXd coefficients() const;

  std::size_t n_;
  Eigen::VectorXd nodes_;
  Eigen::VectorXd weights_;
  Eigen::MatrixXd derivative_;
  Eigen::MatrixXd filter_;
};

/// Weights of Clenshaw and Curtis for n even intervals of [-1, 1].
Eigen::VectorXd clenshaw_curtis(std::size_t intervals);

}  // namespace seiche::exact::slope_climb
