/// Solvers of the systems A lambda = b of a lattice's constraints.
///
///     banded      NinePointCholesky: work cells x n^2, n = min(columns, rows); keeps its factor
///     iterative   conjugate gradients, preconditioned by the undeformed lattice: work cells x iterations
///
/// Automatic takes `banded` up to 20 cells across and where the undeformed lattice is not known, else `iterative`. The
/// number is from verification/performance. Without the undeformed lattice `banded` is faster than sparse Cholesky
/// factorisation up to 190 cells across, at 256 it takes one and a half times as long.
///
/// The preconditioner is
///
///     P = S D^-1 S,   D = matrix of the undeformed lattice,   S = sqrt(diagonal of D / diagonal of A) or 1
///
/// S makes up for cells that are larger, smaller or sheared than the undeformed ones. The undeformed diagonal is that
/// of inner cells, and cells at walls take S from their inner neighbours: their diagonals, halved by the walls, say
/// nothing about deformation.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/cosine_lattice.hpp"
#include "seiche/linear/nine_point_cholesky.hpp"
#include "seiche/linear/worth_threads.hpp"
#include "seiche/require.hpp"

namespace seiche::linear {

/// The undeformed lattice as CosineLattice takes it; unknown (ix, iz, layer) has index (layer nz + iz) nx + ix.
struct UndeformedLattice {
  CosineLattice::Shape shape;
  CosineLattice::LayerMatrix matrix;
  bool scaled = false;  ///< whether S is not 1
};

class LatticeGradients {
 public:
  /// Throws what CosineLattice throws.
  explicit LatticeGradients(UndeformedLattice undeformed)
      : undeformed_(std::move(undeformed)), lattice_(undeformed_.shape, undeformed_.matrix) {
    if (undeformed_.scaled) measure_inner_diagonal();
  }

  /// @param a  must stay as it is until the last solution for it
  void factor(const StencilMatrix& a) {
    matrix_ = &a;
    if (x_.size() != a.size()) right_hand_side_ = x_ = LatticeArray(a.columns(), a.rows() * a.layers());
    if (undeformed_.scaled) scale_by(a[a.own]);
  }

  /// x holds a guess. Returns the iterations. Throws NotConverged, NotPositiveDirection.
  int solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) {
    std::copy(right_hand_side.begin(), right_hand_side.end(), right_hand_side_.data());
    std::copy(x.begin(), x.end(), x_.data());
    const auto multiply = [this](const LatticeArray& p, LatticeArray& q) { return matrix_->multiply_and_dot(p, q); };
    const auto precondition = [this](std::span<const double> r, std::span<double> z, double magnitude) {
      lattice_.solve(r, z, magnitude, scale_);
    };
    const auto result = gradients_.solve(multiply, precondition, right_hand_side_, x_, {.tolerance = tolerance});
    std::copy(x_.values().begin(), x_.values().end(), x.begin());
    return result.iterations;
  }

 private:
  /// The mean of D's diagonal over all phases is the diagonal of a cell without walls.
  void measure_inner_diagonal() {
    const auto [nx, nz, layers] = undeformed_.shape;
    std::vector<double> diagonal(layers);
    std::vector<double> off_diagonal(layers - 1);
    inner_diagonal_.assign(layers, 0.0);
    for (std::size_t l = 0; l < nz; ++l) {
      for (std::size_t m = 0; m < nx; ++m) {
        undeformed_.matrix(std::numbers::pi * static_cast<double>(m) / static_cast<double>(nx),
                           std::numbers::pi * static_cast<double>(l) / static_cast<double>(nz), diagonal, off_diagonal);
        for (std::size_t k = 0; k < layers; ++k) inner_diagonal_[k] += diagonal[k] / static_cast<double>(nx * nz);
      }
    }
  }

  void scale_by(const double* own) {
    const std::size_t nx = undeformed_.shape.nx;
    const std::size_t nz = undeformed_.shape.nz;
    const std::size_t layers = undeformed_.shape.layers;
    scale_.resize(x_.size());
    share_out(nz * layers, scale_.size() > worth_threads, [&](std::size_t row) {
      const double inner = inner_diagonal_[row / nz];
      double* const scale = scale_.data() + row * nx;
#pragma omp simd
      for (std::size_t i = 0; i < nx; ++i) scale[i] = std::sqrt(inner / own[row * nx + i]);
      if (nx > 2) {
        scale[0] = scale[1];
        scale[nx - 1] = scale[nx - 2];
      }
    });
    if (nz < 3) return;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      double* const first = scale_.data() + layer * nz * nx;
      double* const last = first + (nz - 1) * nx;
      std::copy(first + nx, first + 2 * nx, first);
      std::copy(last - nx, last, last);
    }
  }

  UndeformedLattice undeformed_;
  CosineLattice lattice_;
  ConjugateGradients<> gradients_;
  LatticeArray right_hand_side_, x_;
  const StencilMatrix* matrix_ = nullptr;
  std::vector<double> inner_diagonal_;  // by layer
  std::vector<double> scale_;           // empty for 1
};

enum class SolverMethod { automatic, banded, iterative };

class ConstraintSolver {
 public:
  /// @param method      `iterative` needs the undeformed lattice, either all cells in one layer, or each row a layer
  /// @param tolerance   relative residual of the iteration, at most 1e-6. Throws std::invalid_argument.
  ConstraintSolver(std::size_t columns, std::size_t rows, SolverMethod method,
                   std::optional<UndeformedLattice> undeformed, double tolerance)
      : tolerance_(tolerance) {
    constexpr std::size_t widest = 20;  // that is solved directly although iteration is possible
    require_within("tolerance", tolerance, 1e-15, 1e-6);
    if (method == SolverMethod::iterative && !undeformed) {
      throw std::invalid_argument(
          "solver = \"iterative\"; allowed only for meshes between vertical walls, on a bottom");
    }
    const bool fits = !undeformed || std::min(columns, rows) <= widest;
    if (method == SolverMethod::banded || (method == SolverMethod::automatic && fits)) {
      banded_.emplace(columns, rows);
    } else {
      gradients_.emplace(*std::move(undeformed));
    }
  }
  /// Iterative.
  ConstraintSolver(UndeformedLattice undeformed, double tolerance)
      : tolerance_(tolerance), gradients_(std::move(undeformed)) {
    require_within("tolerance", tolerance, 1e-15, 1e-4);
  }

  /// The method in use, never `automatic`.
  [[nodiscard]] SolverMethod method() const { return gradients_ ? SolverMethod::iterative : SolverMethod::banded; }
  /// @param a  must stay as it is until the last solution for it. Throws NotPositiveDefinite.
  void factor(const StencilMatrix& a) {
    ++factorisations_;
    return gradients_ ? gradients_->factor(a) : banded_->factor(a);
  }
  /// x holds a guess for the iteration. Throws NotConverged, NotPositiveDirection.
  /// @param tolerance  instead of the solver's own; 0 for that
  void solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance = 0) {
    ++solutions_;
    if (banded_) return banded_->solve(right_hand_side, x);
    iterations_ += gradients_->solve(right_hand_side, x, tolerance > 0 ? tolerance : tolerance_);
  }

  [[nodiscard]] long factorisations() const { return factorisations_; }
  [[nodiscard]] long solutions() const { return solutions_; }
  [[nodiscard]] long iterations() const { return iterations_; }

 private:
  double tolerance_;
  std::optional<NinePointCholesky> banded_;
  std::optional<LatticeGradients> gradients_;
  long factorisations_ = 0, solutions_ = 0, iterations_ = 0;
};

}  // namespace seiche::linear
