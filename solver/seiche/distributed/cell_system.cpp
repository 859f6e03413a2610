#include "seiche/distributed/cell_system.hpp"

#include "seiche/linear/conjugate_gradients.hpp"

namespace seiche::distributed {

CellSystem::CellSystem(Decomposition& decomposition, double tolerance)
    : decomposition_(decomposition), tolerance_(tolerance) {
  DM cells = decomposition.cells();
  check(DMSetMatrixPreallocateSkip(cells, PETSC_TRUE));
  check(DMCreateMatrix(cells, matrix_.place()));
  check(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
  check(DMCreateGlobalVector(cells, right_hand_side_.place()));
  check(DMCreateGlobalVector(cells, solution_.place()));
  check(KSPCreate(PETSC_COMM_WORLD, solver_.place()));
  check(KSPSetType(solver_, KSPCG));
  check(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
  check(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
  check(KSPSetTolerances(solver_, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, 2000));
  check(KSPSetComputeSingularValues(solver_, PETSC_TRUE));
  PC diagonal = nullptr;
  check(KSPGetPC(solver_, &diagonal));
  check(PCSetType(diagonal, PCJACOBI));
  check(KSPSetFromOptions(solver_));
}

PetscInt CellSystem::number(std::size_t i, std::size_t j, std::size_t layer) const {
  const std::size_t cell = j * decomposition_.patch().shape().columns + i;
  return static_cast<PetscInt>(cell * decomposition_.cell_numbers() + layer);
}

void CellSystem::fix_pattern() {
  check(MatSetPreallocationCOOLocal(matrix_, static_cast<PetscCount>(row_numbers_.size()), row_numbers_.data(),
                                    column_numbers_.data()));
  row_numbers_ = {};
  column_numbers_ = {};
  values_.resize(coefficients_.size());
  check(KSPSetOperators(solver_, matrix_, matrix_));
}

void CellSystem::assemble() {
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = *coefficients_[k];
  check(MatSetValuesCOO(matrix_, values_.data(), INSERT_VALUES));
}

void CellSystem::solve(std::span<const double> right_hand_side, std::span<double> mu) {
  decomposition_.put_cells(right_hand_side, right_hand_side_);
  decomposition_.put_cells(mu, solution_);
  check(KSPSolve(solver_, right_hand_side_, solution_));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(solver_, &reason));
  PetscInt iterations = 0;
  check(KSPGetIterationNumber(solver_, &iterations));
  if (reason <= 0) {
    PetscReal residual = 0;
    PetscReal size = 0;
    check(KSPGetResidualNorm(solver_, &residual));
    check(VecNorm(right_hand_side_, NORM_2, &size));
    if (reason == KSP_DIVERGED_INDEFINITE_MAT) {
      throw linear::NotPositiveDirection("p.Ap", residual, static_cast<int>(iterations));
    }
    if (reason == KSP_DIVERGED_INDEFINITE_PC) {
      throw linear::NotPositiveDirection("r.Pr", residual, static_cast<int>(iterations));
    }
    throw linear::NotConverged(static_cast<int>(iterations), residual / size, tolerance_);
  }
  ++solutions_;
  iterations_ += iterations;
  decomposition_.get_cells(solution_, mu);
}

double CellSystem::condition() const {
  PetscReal largest = 0;
  PetscReal smallest = 0;
  check(KSPComputeExtremeSingularValues(solver_, &largest, &smallest));
  return largest / smallest;
}

}  // namespace seiche::distributed
