#include "distributed/cell_system.hpp"

#include "seiche/linear/conjugate_gradients.hpp"

namespace seiche::distributed {

CellSystem::CellSystem(Decomposition& decomposition, const linear::StencilMatrix& of_patch, double tolerance)
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
  fix_pattern(of_patch);
}

void CellSystem::fix_pattern(const linear::StencilMatrix& of_patch) {
  const auto columns = static_cast<std::ptrdiff_t>(of_patch.columns());
  const auto rows = static_cast<std::ptrdiff_t>(of_patch.rows());
  const auto layers = static_cast<std::ptrdiff_t>(of_patch.layers());
  const auto cell = [&](std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t l) {
    return static_cast<std::size_t>((l * rows + j) * columns + i);
  };
  // In the process's own numbering with the ring.
  const auto number = [&](std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t l) {
    return static_cast<PetscInt>((j * columns + i) * layers + l);
  };
  std::vector<PetscInt> row_numbers, column_numbers;
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
      if (!decomposition_.patch().owns_cell(static_cast<std::size_t>(i), static_cast<std::size_t>(j))) continue;
      for (std::ptrdiff_t l = 0; l < layers; ++l) {
        for (int n = 0; n < 27; ++n) {
          const std::ptrdiff_t at_i = i + n % 3 - 1;
          const std::ptrdiff_t at_j = j + n / 3 % 3 - 1;
          const std::ptrdiff_t at_l = l + n / 9 - 1;
          if (at_i < 0 || at_j < 0 || at_l < 0 || at_i >= columns || at_j >= rows || at_l >= layers) continue;
          coefficients_.push_back(&of_patch.coefficient(cell(i, j, l), cell(at_i, at_j, at_l)));
          row_numbers.push_back(number(i, j, l));
          column_numbers.push_back(number(at_i, at_j, at_l));
        }
      }
    }
  }
  check(MatSetPreallocationCOOLocal(matrix_, static_cast<PetscCount>(row_numbers.size()), row_numbers.data(),
                                    column_numbers.data()));
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
