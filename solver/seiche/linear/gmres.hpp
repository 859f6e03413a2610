/// Generalised minimal residuals for A x = b with a well-conditioned A: no preconditioner, no restart.
///
/// For second-kind integral equations, whose residual falls by a nearly constant factor per iteration. Not for sparse
/// matrices of differential operators.
///
/// Reference: Saad & Schultz, GMRES: a generalized minimal residual algorithm, SIAM J. Sci. Stat. Comput. 7 (1986) 856.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Jacobi>

namespace seiche::linear {

class Gmres {
 public:
  /// Solves A x = b from x = 0 until |b - A x| <= tolerance |b|, by the recurrence. Returns the iterations taken.
  ///
  /// @param apply  apply(x, y) sets y = A x; both Eigen::VectorXd of the length of b
  template <class Apply>
  int solve(const Apply& apply, const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance,
            int most_iterations = 100) {
    product_ = b;
    norm_ = b.norm();
    const double goal = tolerance * norm_;
    double residual = norm_;
    hessenberg_.resize(most_iterations + 1, most_iterations);
    rotated_.resize(most_iterations + 1);
    rotated_[0] = norm_;
    rotations_.clear();
    int k = 0;
    while (residual > goal && k < most_iterations) {
      grow_basis(k);
      apply(basis_[static_cast<std::size_t>(k)], product_);
      residual = orthogonalise(k);
      ++k;
    }
    const Eigen::VectorXd weights =
        hessenberg_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rotated_.head(k));
    x.setZero(b.size());
    for (int i = 0; i < k; ++i) x += weights[i] * basis_[static_cast<std::size_t>(i)];
    return k;
  }

 private:
  void grow_basis(int k) {
    const auto i = static_cast<std::size_t>(k);
    if (basis_.size() <= i) basis_.emplace_back(product_.size());
    basis_[i] = product_ / norm_;
  }

  /// Step k of Arnoldi by modified Gram-Schmidt, then Givens rotations; returns the new residual norm.
  double orthogonalise(int k) {
    for (int i = 0; i <= k; ++i) {
      const Eigen::VectorXd& direction = basis_[static_cast<std::size_t>(i)];
      hessenberg_(i, k) = direction.dot(product_);
      product_ -= hessenberg_(i, k) * direction;
    }
    norm_ = product_.norm();
    hessenberg_(k + 1, k) = norm_;
    for (int i = 0; i < k; ++i) {
      hessenberg_.col(k).applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    }
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(hessenberg_(k, k), hessenberg_(k + 1, k));
    rotations_.push_back(rotation);
    hessenberg_.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotated_[k + 1] = 0;
    rotated_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    return std::abs(rotated_[k + 1]);
  }

  std::vector<Eigen::VectorXd> basis_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  Eigen::MatrixXd hessenberg_;
  Eigen::VectorXd rotated_;
  Eigen::VectorXd product_;
  double norm_ = 0;
};

}  // namespace seiche::linear
