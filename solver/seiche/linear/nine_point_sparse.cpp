#include "seiche/linear/nine_point_sparse.hpp"

#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require.hpp"

namespace seiche::linear {
namespace {

/// action(coefficients, cell, row of the triangle) for every coupling inside the lattice, column by column of the
/// triangle, rows ascending.
template <class Action>
void for_each_coupling(const NinePointMatrix& a, const Action& action) {
  for (std::size_t j = 0, c = 0; j < a.rows; ++j) {
    for (std::size_t i = 0; i < a.columns; ++i, ++c) {
      const bool right = i + 1 < a.columns;
      action(a.own, c, c);
      if (right) action(a.right, c, c + 1);
      if (j + 1 == a.rows) continue;
      if (i > 0) action(a.up_left, c, c + a.columns - 1);
      action(a.up, c, c + a.columns);
      if (right) action(a.up_right, c, c + a.columns + 1);
    }
  }
}

Eigen::SparseMatrix<double> pattern(std::size_t columns, std::size_t rows) {
  require_at_least("columns", static_cast<long>(columns), 1);
  require_at_least("rows", static_cast<long>(rows), 1);
  constexpr int most_cells = std::numeric_limits<int>::max() / 5;
  require_within("columns x rows", static_cast<double>(columns) * static_cast<double>(rows), 1, most_cells);
  const auto cells = static_cast<int>(columns * rows);
  Eigen::SparseMatrix<double> result(cells, cells);
  result.reserve(Eigen::VectorXi::Constant(cells, 5));
  for_each_coupling(NinePointMatrix(columns, rows), [&](const LatticeArray&, std::size_t c, std::size_t row) {
    result.insert(static_cast<int>(row), static_cast<int>(c)) = 1;
  });
  result.makeCompressed();
  return result;
}

}  // namespace

NinePointSparse::NinePointSparse(std::size_t columns, std::size_t rows)
    : columns_(columns), rows_(rows), cholesky_(pattern(columns, rows)) {}

void NinePointSparse::factor(const NinePointMatrix& a) {
  if (a.columns != columns_ || a.rows != rows_) {
    throw std::invalid_argument(
        fmt::format("matrix of a {} x {} lattice; expected {} x {}", a.columns, a.rows, columns_, rows_));
  }
  values_.clear();
  for_each_coupling(a,
                    [&](const LatticeArray& from, std::size_t c, std::size_t) { values_.push_back(from.data()[c]); });
  cholesky_.factor(values_);
}

}  // namespace seiche::linear
