/// The system A mu = b of all cells, shared out as the cells are, solved by PETSc.
///
/// Rows of A come from the patches' own matrices, whose coefficients around owned cells are whole. The Krylov method is
/// conjugate gradients, preconditioned by the diagonal, from the guess given, until |b - A mu| <= tolerance |b|
/// (Euclidean norms), as linear::ConjugateGradients does. PETSc's options change it: -ksp_type, -pc_type, ...
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/distributed/decomposition.hpp"
#include "seiche/distributed/stored_coefficients.hpp"

namespace seiche::distributed {

class CellSystem {
 public:
  /// @param decomposition  must outlive the object
  /// @param tolerance      relative residual
  template <class PatchMatrix>
  CellSystem(Decomposition& decomposition, const PatchMatrix& of_patch, double tolerance)
      : CellSystem(decomposition, tolerance) {
    find_coefficients(of_patch);
    fix_pattern();
  }

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
  CellSystem(Decomposition& decomposition, double tolerance);
  template <class PatchMatrix>
  void find_coefficients(const PatchMatrix& of_patch);
  void fix_pattern();
  /// Row or column of A, in the process's own numbering with the ring.
  [[nodiscard]] PetscInt number(std::size_t i, std::size_t j, std::size_t layer) const;

  Decomposition& decomposition_;
  double tolerance_;
  DistributedMatrix matrix_;
  DistributedVector right_hand_side_, solution_;
  KrylovSolver solver_;
  std::vector<const double*> coefficients_;  // in the order of the pattern's entries
  std::vector<PetscInt> row_numbers_, column_numbers_;
  std::vector<PetscScalar> values_;
  long solutions_ = 0;
  long iterations_ = 0;
};

template <class PatchMatrix>
void CellSystem::find_coefficients(const PatchMatrix& of_patch) {
  const plan_lattice::Shape shape = decomposition_.patch().shape();
  const std::size_t layers = layers_of(of_patch);
  const auto next = [](std::size_t from, int step) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + step);
  };
  const auto inside = [](std::size_t from, int step, std::size_t count) {
    return step < 0 ? from > 0 : from + static_cast<std::size_t>(step) < count;
  };
  for (std::size_t j = 0; j < shape.rows; ++j) {
    for (std::size_t i = 0; i < shape.columns; ++i) {
      if (!decomposition_.patch().owns_cell(i, j)) continue;
      for (std::size_t l = 0; l < layers; ++l) {
        for (int n = 0; n < 27; ++n) {
          const int di = n % 3 - 1;
          const int dj = n / 3 % 3 - 1;
          const int dl = n / 9 - 1;
          if (!inside(i, di, shape.columns) || !inside(j, dj, shape.rows) || !inside(l, dl, layers)) continue;
          coefficients_.push_back(stored_coefficient(of_patch, i, j, l, di, dj, dl));
          row_numbers_.push_back(number(i, j, l));
          column_numbers_.push_back(number(next(i, di), next(j, dj), next(l, dl)));
        }
      }
    }
  }
}

}  // namespace seiche::distributed
