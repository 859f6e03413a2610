#include "seiche/linear/twenty_seven_point_solver.hpp"

#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "seiche/linear/sparse_cholesky.hpp"
#include "seiche/require.hpp"

namespace seiche::linear {

namespace {

/// action(coefficient, cell, row of the triangle) for every coupling inside the lattice, column by column of the lower
/// triangle, rows ascending.
template <class Action>
void for_each_coupling(const TwentySevenPointMatrix& a, const Action& action) {
  const auto inside = [](std::size_t from, int by, std::size_t end) {
    return by < 0 ? from > 0 : from + static_cast<std::size_t>(by) < end;
  };
  const auto columns = static_cast<std::ptrdiff_t>(a.columns);
  const auto rows = static_cast<std::ptrdiff_t>(a.rows);
  for (std::size_t l = 0, c = 0; l < a.layers; ++l) {
    for (std::size_t j = 0; j < a.rows; ++j) {
      for (std::size_t i = 0; i < a.columns; ++i, ++c) {
        action(a.own.data()[c], c, c);
        for (int dl = 0; dl <= 1; ++dl) {
          for (int dj = dl == 1 ? -1 : 0; dj <= 1; ++dj) {
            for (int di = dl == 0 && dj == 0 ? 1 : -1; di <= 1; ++di) {
              if (!inside(i, di, a.columns) || !inside(j, dj, a.rows) || !inside(l, dl, a.layers)) continue;
              const std::ptrdiff_t offset = (dl * rows + dj) * columns + di;
              action(a.later.row(l * a.rows + j)[later_neighbour(di, dj, dl)][i], c,
                     static_cast<std::size_t>(static_cast<std::ptrdiff_t>(c) + offset));
            }
          }
        }
      }
    }
  }
}

Eigen::SparseMatrix<double> pattern(CosineLattice::Shape shape) {
  constexpr int most_cells = std::numeric_limits<int>::max() / 14;
  require_within("cells", static_cast<double>(shape.nx) * static_cast<double>(shape.nz * shape.layers), 1, most_cells);
  const TwentySevenPointMatrix a(shape.nx, shape.nz, shape.layers);
  const auto cells = static_cast<int>(a.size());
  Eigen::SparseMatrix<double> result(cells, cells);
  result.reserve(Eigen::VectorXi::Constant(cells, 14));
  for_each_coupling(a, [&](double, std::size_t c, std::size_t row) {
    result.insert(static_cast<int>(row), static_cast<int>(c)) = 1;
  });
  result.makeCompressed();
  return result;
}

}  // namespace

std::string_view name(TwentySevenPointMethod method) {
  return method == TwentySevenPointMethod::iterative ? "iterative" : "sparse";
}

TwentySevenPointMethod twenty_seven_point_method_named(std::string_view name) {
  if (name == "iterative") return TwentySevenPointMethod::iterative;
  if (name == "sparse") return TwentySevenPointMethod::sparse;
  throw std::invalid_argument(fmt::format("solver = \"{}\"; allowed: iterative, sparse", name));
}

class TwentySevenPointSolver::Implementation {
 public:
  virtual ~Implementation() = default;
  virtual void factor(const TwentySevenPointMatrix& a) = 0;
  /// Returns the iterations taken.
  virtual int solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) = 0;
};

class TwentySevenPointSolver::Iterative final : public Implementation {
 public:
  explicit Iterative(UndeformedLattice undeformed) : gradients_(std::move(undeformed)) {}
  void factor(const TwentySevenPointMatrix& a) override { gradients_.factor(a); }
  int solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) override {
    return gradients_.solve(right_hand_side, x, tolerance);
  }

 private:
  LatticeGradients<TwentySevenPointMatrix> gradients_;
};

class TwentySevenPointSolver::Sparse final : public Implementation {
 public:
  explicit Sparse(CosineLattice::Shape shape) : cholesky_(pattern(shape)) {}
  void factor(const TwentySevenPointMatrix& a) override {
    values_.clear();
    for_each_coupling(a, [&](double value, std::size_t, std::size_t) { values_.push_back(value); });
    cholesky_.factor(values_);
  }
  int solve(std::span<const double> right_hand_side, std::span<double> x, double) override {
    cholesky_.solve(right_hand_side, x);
    return 0;
  }

 private:
  SparseCholesky cholesky_;
  std::vector<double> values_;
};

TwentySevenPointSolver::TwentySevenPointSolver(TwentySevenPointMethod method, UndeformedLattice undeformed,
                                               double tolerance)
    : method_(method), tolerance_(tolerance) {
  require_within("tolerance", tolerance, 1e-15, 1e-4);
  if (method == TwentySevenPointMethod::iterative) {
    implementation_ = std::make_unique<Iterative>(std::move(undeformed));
  } else {
    implementation_ = std::make_unique<Sparse>(undeformed.shape);
  }
}

TwentySevenPointSolver::~TwentySevenPointSolver() = default;
TwentySevenPointSolver::TwentySevenPointSolver(TwentySevenPointSolver&&) noexcept = default;
TwentySevenPointSolver& TwentySevenPointSolver::operator=(TwentySevenPointSolver&&) noexcept = default;

void TwentySevenPointSolver::factor(const TwentySevenPointMatrix& a) {
  implementation_->factor(a);
}

void TwentySevenPointSolver::solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) {
  last_iterations_ = implementation_->solve(right_hand_side, x, tolerance > 0 ? tolerance : tolerance_);
  iterations_ += last_iterations_;
  ++solutions_;
}

}  // namespace seiche::linear
