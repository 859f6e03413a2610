/// The solver of a 27-point system.
///
///     iterative   LatticeGradients: conjugate gradients, preconditioned by the undeformed lattice; any size
///     sparse      SparseCholesky (CHOLMOD): an independent check, and small lattices whose cells are far from the
///                 undeformed ones; memory grows like cells^(4/3)
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "seiche/linear/lattice_gradients.hpp"
#include "seiche/linear/twenty_seven_point_matrix.hpp"

namespace seiche::linear {

enum class TwentySevenPointMethod { iterative, sparse };
std::string_view name(TwentySevenPointMethod method);
/// Throws std::invalid_argument listing the names there are.
TwentySevenPointMethod twenty_seven_point_method_named(std::string_view name);

class TwentySevenPointSolver {
 public:
  /// @param tolerance  relative residual of the iteration, at most 1e-4. Throws std::invalid_argument.
  TwentySevenPointSolver(TwentySevenPointMethod method, UndeformedLattice undeformed, double tolerance);
  ~TwentySevenPointSolver();
  TwentySevenPointSolver(TwentySevenPointSolver&&) noexcept;
  TwentySevenPointSolver& operator=(TwentySevenPointSolver&&) noexcept;

  [[nodiscard]] TwentySevenPointMethod method() const { return method_; }
  /// @param a  must stay as it is until the last solution for it. Throws NotPositiveDefinite.
  void factor(const TwentySevenPointMatrix& a);
  /// x holds a guess for the iteration. Throws NotConverged, NotPositiveDirection.
  /// @param tolerance  instead of the solver's own; 0 for that
  void solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance = 0);

  [[nodiscard]] long solutions() const { return solutions_; }
  /// Of the iterative method, of all solutions and of the last one.
  [[nodiscard]] long iterations() const { return iterations_; }
  [[nodiscard]] int last_iterations() const { return last_iterations_; }

 private:
  class Implementation;
  class Iterative;
  class Sparse;

  TwentySevenPointMethod method_;
  double tolerance_;
  std::unique_ptr<Implementation> implementation_;
  long solutions_ = 0;
  long iterations_ = 0;
  int last_iterations_ = 0;
};

}  // namespace seiche::linear
