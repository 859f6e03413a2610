/// The solver that fits a nine-point system, behind one face, chosen by the shape of the lattice.
///
///     banded      NinePointCholesky: work cells x n^2, n = min(columns, rows)
///     sparse      SparseCholesky (CHOLMOD): any shape, memory grows like cells log cells
///     iterative   conjugate gradients, preconditioned by the undeformed lattice: work cells x iterations
///
/// Automatic takes `banded` up to 20 cells across, or 100 where the undeformed lattice is not known; beyond,
/// `iterative` if it is known, else `sparse`. The numbers are from verification/performance. The direct solvers keep
/// their factors, so that further solutions are cheap.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "seiche/linear/lattice_gradients.hpp"
#include "seiche/linear/nine_point_matrix.hpp"
#include "seiche/linear/sparse_cholesky.hpp"

namespace seiche::linear {

enum class NinePointMethod { automatic, banded, sparse, iterative };
std::string_view name(NinePointMethod method);
/// Throws std::invalid_argument listing the names there are.
NinePointMethod nine_point_method_named(std::string_view name);

/// Cells across up to which `banded` beats `sparse` once.
inline constexpr std::size_t widest_banded = 100;

class NinePointSolver {
 public:
  /// @param undeformed  `iterative` needs it; either all cells in one layer, or each row a layer
  /// @param tolerance   relative residual of the iteration, at most 1e-6. Throws std::invalid_argument.
  NinePointSolver(std::size_t columns, std::size_t rows, NinePointMethod method,
                  std::optional<UndeformedLattice> undeformed, double tolerance);
  ~NinePointSolver();
  NinePointSolver(NinePointSolver&&) noexcept;
  NinePointSolver& operator=(NinePointSolver&&) noexcept;

  /// The method in use, never `automatic`.
  [[nodiscard]] NinePointMethod method() const { return method_; }
  /// @param a  must stay as it is until the last solution for it. Throws NotPositiveDefinite.
  void factor(const NinePointMatrix& a);
  /// x holds a guess for the iteration. Throws NotConverged, NotPositiveDirection.
  /// @param tolerance  instead of the solver's own; 0 for that
  void solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance = 0);

  /// Of the last factor; nothing of the iterative method.
  [[nodiscard]] FactorWork factor_work() const;
  [[nodiscard]] long factorisations() const { return factorisations_; }
  [[nodiscard]] long solutions() const { return solutions_; }
  /// Of the iterative method, of all solutions and of the last one.
  [[nodiscard]] long iterations() const { return iterations_; }
  [[nodiscard]] int last_iterations() const { return last_iterations_; }

 private:
  class Implementation;
  template <class Cholesky>
  class Direct;
  class Iterative;

  NinePointMethod method_;
  double tolerance_;
  std::unique_ptr<Implementation> implementation_;
  long factorisations_ = 0;
  long solutions_ = 0;
  long iterations_ = 0;
  int last_iterations_ = 0;
};

}  // namespace seiche::linear
