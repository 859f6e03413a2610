// Factors tell their entries and the operations that make them: benchmarks are read by these numbers.
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "seiche/linear/sparse_cholesky.hpp"
#include "verification/check.hpp"

namespace seiche::verification::factor_work_test {

using linear::FactorWork;

/// Of the pattern with `below` entries under every diagonal, eliminated as it stands.
FactorWork banded(int n, int below) {
  Eigen::SparseMatrix<double> pattern(n, n);
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < std::min(n, j + below + 1); ++i) pattern.insert(i, j) = 1;
  }
  pattern.makeCompressed();
  std::vector<int> ordering(static_cast<std::size_t>(n));
  std::iota(ordering.begin(), ordering.end(), 0);
  return linear::SparseCholesky(pattern, ordering).work();
}

/// Columns of c entries: that many numbers, and c^2 operations each.
FactorWork by_columns(int n, int below) {
  FactorWork work;
  for (int j = 0; j < n; ++j) {
    const double entries = std::min(n - j, below + 1);
    work.entries += entries;
    work.operations += entries * entries;
  }
  return work;
}

TEST_CASE("factors report their entries and operations", "[linear]") {
  Check check("factor_work", "What a factor costs",
              "Entries and operations of Cholesky factors, as the solvers report them, compared with sums over the "
              "columns of bands and full matrices.");
  for (const auto& [id, n, below] : {std::tuple{"tridiagonal", 50, 1}, {"wide", 60, 7}, {"full", 20, 19}}) {
    const FactorWork told = banded(n, below), counted = by_columns(n, below);
    check.holds(id + std::string(": The solver reports the entries and operations of its factor."),
                {std::abs(told.entries - counted.entries) + std::abs(told.operations - counted.operations)},
                Bound{0, "whole numbers"});
  }
}

}  // namespace seiche::verification::factor_work_test
