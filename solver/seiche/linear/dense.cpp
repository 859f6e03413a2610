#include "seiche/linear/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace seiche::linear {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricEigen symmetric_eigen(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

MatrixXd complement(const MatrixXd& columns) {
  const Eigen::ColPivHouseholderQR<MatrixXd> factors(columns);
  const MatrixXd basis = factors.householderQ();
  return basis.rightCols(columns.rows() - factors.rank());
}

VectorXd least_squares(const MatrixXd& matrix, const VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

struct LuFactors::Factors {
  explicit Factors(MatrixXd& matrix) : lu(matrix) {}
  Eigen::PartialPivLU<Eigen::Ref<MatrixXd>> lu;
};

LuFactors::LuFactors(MatrixXd& matrix) : factors_(std::make_unique<Factors>(matrix)) {}
LuFactors::~LuFactors() = default;

VectorXd LuFactors::solve(const VectorXd& right) const {
  return factors_->lu.solve(right);
}

}  // namespace seiche::linear
