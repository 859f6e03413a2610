/// The system A mu = b of all cells, shared out as the cells are, solved by PETSc.
///
/// Rows of A come from the patches' own matrices, whose coefficients around owned cells are whole. The Krylov method is
/// conjugate gradients, preconditioned by the diagonal, from the guess given, until |b - A mu| <= tolerance |b|
/// (Euclidean norms), as linear::ConjugateGradients does. PETSc's options change it: -ksp_type, -pc_type, ...
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "distributed/decomposition.hpp"
#include "seiche/linear/conjugate_gradients.hpp"

namespace seiche::distributed {

class CellSystem {
 public:
  /// @param decomposition  must outlive the object, as of_patch
  /// @param tolerance      relative residual
  CellSystem(Decomposition& decomposition, const linear::StencilMatrix& of_patch, double tolerance);

  /// Takes over the coefficients that the patch's matrix has now.
  void assemble();
  /// @param right_hand_side  one number per cell of the patch, of which owned ones are read
  /// @param mu               on entry a guess in the owned cells, on exit the solution in all cells of the patch
  ///
  /// Throws linear::NotConverged and NotPositiveDirection, on all processes alike.
  void solve(std::span<const double> right_hand_side, std::span<double> mu);

  [[nodiscard]] long solutions() const { return solutions_; }
  [[nodiscard]] long iterations() const { return iterations_; }
  /// Largest over smallest singular value of the preconditioned matrix as the last solution found them.
  [[nodiscard]] double condition() const;

 private:
  void fix_pattern(const linear::StencilMatrix& of_patch);

  Decomposition& decomposition_;
  double tolerance_;
  DistributedMatrix matrix_;
  DistributedVector right_hand_side_, solution_;
  KrylovSolver solver_;
  std::vector<const double*> coefficients_;  // in the order of the pattern's entries
  std::vector<PetscScalar> values_;
  long solutions_ = 0;
  long iterations_ = 0;
};

}  // namespace seiche::distributed
