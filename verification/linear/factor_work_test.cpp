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

double difference(FactorWork a, FactorWork b) {
  return std::abs(a.entries - b.entries) + std::abs(a.operations - b.operations);
}

TEST_CASE("factors report their entries and operations", "[linear]") {
  Check check("factor_work", "What a factor costs",
              "Entries and operations of Cholesky factors, as the solvers report them, compared with sums over the "
              "columns of bands and full matrices.");
  const auto same = [&](const std::string& id, FactorWork told, FactorWork counted) {
    check.holds(id + ": The solver reports the entries and operations of its factor.", {difference(told, counted)},
                Bound{0, "whole numbers"});
  };
  same("tridiagonal", banded(50, 1), by_columns(50, 1));
  same("wide", banded(60, 7), by_columns(60, 7));
  same("full", banded(20, 19), by_columns(20, 19));
}

}  // namespace seiche::verification::factor_work_test
