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
#include <optional>
#include <span>
#include <vector>

#include <Eigen/SparseCore>

namespace seiche::linear {

/// Of a factor: its entries, and the operations that make it.
struct FactorWork {
  double entries = 0;
  double operations = 0;
};

class SparseCholesky {
 public:
  /// @param pattern   lower triangle with its diagonal, compressed; its values do not matter. Throws
  ///                  std::invalid_argument.
  /// @param ordering  the elimination order of a pattern that was nearly the same: spares finding one
  explicit SparseCholesky(const Eigen::SparseMatrix<double>& pattern, std::span<const int> ordering = {});
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

/// Symmetric matrices that are sums of small dense blocks, one for each ring of unknowns, A = sum_k P_k B_k P_k^T, and
/// their direct solution.
///
/// The matrix of a free-Lagrangian mesh has a ring for each node, the cells whose volume the node changes: G W G^T is
/// the sum of its blocks, and so is the square of a Laplacian on the same rings. The pattern, about 19 entries in a row
/// for cells in the plane, follows the rings and is found anew when they change.
///
/// The solver is sparse Cholesky (CHOLMOD), analysed anew only when the pattern is another one, and then in the
/// elimination order of the first as long as that fits. It factorises A + shift I and refines its solutions twice with
/// A itself: the shift leaves no trace unless A is singular.
///
/// When not to use it: beyond some million unknowns (1e6 Dirichlet cells: 8 s a step and 3.3 GB).
class RingMatrix {
 public:
  /// @param begin    ring k are the members begin[k] to begin[k+1] - 1, each unknown at most once
  /// @param unknowns  every one must be in a ring. Throws std::invalid_argument
  void set_rings(std::span<const int> begin, std::span<const int> member, std::size_t unknowns);

  /// Replaces the values. @param block  block(k, p, q): entry of B_k for the members p >= q of ring k, counted within
  /// it
  template <class Block>
  void sum(Block&& block) {
    lower_.coeffs().setZero();
    double* const values = lower_.valuePtr();
    std::size_t pair = 0;
    for (std::size_t k = 0; k + 1 < begin_.size(); ++k) {
      const int n = begin_[k + 1] - begin_[k];
      for (int p = 0; p < n; ++p) {
        for (int q = 0; q <= p; ++q) values[place_[pair++]] += block(k, p, q);
      }
    }
  }

  /// Lower triangle, compressed, each column beginning with its diagonal.
  [[nodiscard]] const Eigen::SparseMatrix<double>& lower() const { return lower_; }
  [[nodiscard]] std::span<const double> values() const {
    return {lower_.valuePtr(), static_cast<std::size_t>(lower_.nonZeros())};
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(lower_.cols()); }
  /// Grows with every set_rings: whoever analysed a pattern knows whether it is the same.
  [[nodiscard]] long pattern() const { return pattern_; }

 private:
  std::vector<int> begin_;
  std::vector<int> place_;  // of each pair of each ring among the values
  Eigen::SparseMatrix<double> lower_;
  long pattern_ = 0;
};

class RingSolver {
 public:
  /// @param a      must stay as it is until the last solution for it. Throws NotPositiveDefinite
  /// @param shift  added to the diagonal of what is factorised
  void factor(const RingMatrix& a, double shift);
  /// Pressures' matrix, of which no more than a stabilised one is known to be regular.
  /// @param mean  of its diagonal
  /// @return nothing; of a singular matrix the smallest pivot over the largest, below `smallest_pivot`
  [[nodiscard]] std::optional<double> factor_or_singular(const RingMatrix& a, double mean, bool stabilised);
  static constexpr double smallest_pivot = 1e-10;
  void solve(std::span<const double> right_hand_side, std::span<double> x);

  /// Smallest pivot over the largest.
  [[nodiscard]] double pivot_ratio() const { return cholesky_->pivot_ratio(); }
  /// Of the last factor.
  [[nodiscard]] FactorWork factor_work() const { return cholesky_->work(); }
  [[nodiscard]] long analyses() const { return analyses_; }
  [[nodiscard]] long factorisations() const { return factorisations_; }

 private:
  void analyse(const RingMatrix& a);

  const RingMatrix* matrix_ = nullptr;
  std::optional<SparseCholesky> cholesky_;
  double fill_ = 0;  // of the first factor in its order
  std::vector<double> shifted_;
  Eigen::VectorXd residual_;
  long pattern_ = 0, analyses_ = 0, factorisations_ = 0;
};

}  // namespace seiche::linear
