/// Factorisations of small dense matrices by Eigen, compiled once and not in every file that needs one.
#pragma once

#include <memory>

#include <Eigen/Core>

namespace seiche::linear {

/// Eigenvalues of a symmetric matrix in increasing order and its orthonormal eigenvectors, as columns.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// Orthonormal columns that span what the columns of a matrix do not reach, the kernel of its transpose; by Householder
/// reflections with column pivoting, which also decide the rank.
Eigen::MatrixXd complement(const Eigen::MatrixXd& columns);

/// x that makes |matrix x - right| smallest, by Householder reflections with column pivoting.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// LU factors with partial pivoting of a square matrix, which holds them from then on.
class LuFactors {
 public:
  explicit LuFactors(Eigen::MatrixXd& matrix);
  LuFactors(const LuFactors&) = delete;
  LuFactors& operator=(const LuFactors&) = delete;
  LuFactors(LuFactors&&) = delete;
  LuFactors& operator=(LuFactors&&) = delete;
  ~LuFactors();

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace seiche::linear
