/// Solves symmetric positive definite systems whose pattern changes now and then (RingMatrix).
///
///     direct      sparse Cholesky (CHOLMOD): analysed anew only when the pattern is another one, and then in the
///                 elimination order of the first as long as that fits. A factor of A + shift I, whose solutions are
///                 refined twice with A itself: the shift leaves no trace unless A is singular.
///     iterative   conjugate gradients, preconditioned by an incomplete Cholesky factor
///
/// Automatic takes `direct` up to 1e6 unknowns: iterations grow as the rows of a mesh, and the factor is the faster one
/// there (11 times at 1e5 Dirichlet cells; at 1e6 a step takes 8 s and 3.3 GB). Only the direct method can tell that a
/// matrix is singular.
///
/// References: Chen, Davis, Hager & Rajamanickam, Algorithm 887, ACM Trans. Math. Softw. 35 (2008) 22; Lin & More,
/// Incomplete Cholesky factorizations with limited memory, SIAM J. Sci. Comput. 21 (1999) 24.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "seiche/linear/ring_matrix.hpp"
#include "seiche/linear/sparse_cholesky.hpp"

namespace seiche::linear {

enum class RingMethod { automatic, direct, iterative };
/// Throws std::invalid_argument listing the names there are.
RingMethod ring_method_named(std::string_view name);

class RingSolver {
 public:
  static constexpr std::size_t most_direct = 1000000;  // unknowns

  /// @param tolerance  relative residual of the iteration, in (0, 1e-6]. Throws std::invalid_argument
  RingSolver(std::size_t unknowns, RingMethod method, double tolerance);
  ~RingSolver();
  RingSolver(RingSolver&&) noexcept;
  RingSolver& operator=(RingSolver&&) noexcept;

  /// The method in use, never `automatic`.
  [[nodiscard]] RingMethod method() const { return method_; }
  /// @param a      must stay as it is until the last solution for it. Throws NotPositiveDefinite
  /// @param shift  added to the diagonal of what is factorised
  void factor(const RingMatrix& a, double shift);
  /// x holds a guess for the iteration. Throws NotConverged, NotPositiveDirection.
  void solve(std::span<const double> right_hand_side, std::span<double> x);

  /// Smallest pivot over the largest of the direct method, 1 of the other one.
  [[nodiscard]] double pivot_ratio() const;
  /// Of the last factor, without what the incomplete one of the iterative method takes.
  [[nodiscard]] FactorWork factor_work() const;
  [[nodiscard]] long analyses() const { return analyses_; }
  [[nodiscard]] long factorisations() const { return factorisations_; }
  [[nodiscard]] long iterations() const { return iterations_; }

 private:
  class Implementation;
  class Direct;
  class Iterative;

  RingMethod method_;
  std::unique_ptr<Implementation> implementation_;
  long pattern_ = 0;  // analysed last
  long analyses_ = 0;
  long factorisations_ = 0;
  long iterations_ = 0;
};

}  // namespace seiche::linear
