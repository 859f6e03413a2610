/// Cholesky factorisation of sparse symmetric positive definite matrices whose pattern stays (CHOLMOD).
///
/// Ordering and symbolic analysis are done once, for the pattern; factor takes new values as often as wanted. With a
/// BLAS of one thread results are the same to the last byte however many threads the program has.
///
/// When not to use it: nine-point systems on long lattices (NinePointCholesky); more than some million unknowns
/// (iteration).
///
/// Reference: Chen, Davis, Hager & Rajamanickam, Algorithm 887: CHOLMOD, ACM Trans. Math. Softw. 35 (2008) 22.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <Eigen/SparseCore>

namespace seiche::linear {

/// Of a factor: its entries, and the operations that make it.
struct FactorWork {
  double entries = 0;
  double operations = 0;
};

class SparseCholesky {
 public:
  /// @param pattern  lower triangle with its diagonal, compressed; its values do not matter. Throws
  ///                 std::invalid_argument.
  explicit SparseCholesky(const Eigen::SparseMatrix<double>& pattern);
  /// @param ordering  the elimination order of a pattern that was nearly the same: spares finding one
  SparseCholesky(const Eigen::SparseMatrix<double>& pattern, std::span<const int> ordering);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Values in the order of the pattern's. Throws std::invalid_argument for another number of them,
  /// NotPositiveDefinite.
  void factor(std::span<const double> values);
  /// Arrays may be the same. After factor; one thread at a time.
  void solve(std::span<const double> right_hand_side, std::span<double> x) const;

  [[nodiscard]] std::size_t size() const;
  /// Unknowns in the order of their elimination.
  [[nodiscard]] std::span<const int> ordering() const;
  /// By the symbolic analysis.
  [[nodiscard]] FactorWork work() const;
  /// Smallest pivot over the largest, after factor.
  [[nodiscard]] double pivot_ratio() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace seiche::linear
