#include "seiche/linear/ring_solver.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/require_that.hpp"

namespace seiche::linear {

namespace {

std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

/// For each unknown, the rings it is in and its number within them.
struct Memberships {
  struct In {
    int ring, number;
  };
  std::vector<int> begin;
  std::vector<In> in;

  Memberships(std::span<const int> ring_begin, std::span<const int> member, std::size_t unknowns)
      : begin(unknowns + 1, 0), in(member.size()) {
    for (const int i : member) ++begin[index(i) + 1];
    for (std::size_t i = 0; i < unknowns; ++i) {
      require_that(begin[i + 1] != 0, "unknown {} is in no ring", i);
      begin[i + 1] += begin[i];
    }
    std::vector<int> filled(begin.begin(), begin.end() - 1);
    for (std::size_t k = 0; k + 1 < ring_begin.size(); ++k) {
      for (int e = ring_begin[k]; e < ring_begin[k + 1]; ++e) {
        in[index(filled[index(member[index(e)])]++)] = {static_cast<int>(k), e - ring_begin[k]};
      }
    }
  }
};

}  // namespace

void RingMatrix::set_rings(std::span<const int> begin, std::span<const int> member, std::size_t unknowns) {
  const Memberships memberships(begin, member, unknowns);
  begin_.assign(begin.begin(), begin.end());
  // Pairs p >= q of a ring of n members: p (p + 1)/2 + q, after those of the rings before.
  std::vector<int> pairs(begin_.size());
  for (std::size_t k = 0; k + 1 < begin_.size(); ++k) {
    const int n = begin_[k + 1] - begin_[k];
    pairs[k + 1] = pairs[k] + n * (n + 1) / 2;
  }
  place_.resize(index(pairs.back()));
  std::vector<int> columns(unknowns + 1, 0);
  std::vector<int> rows;
  rows.reserve(12 * unknowns);
  std::vector<int> at(unknowns, -1);
  for (std::size_t j = 0; j < unknowns; ++j) {
    const std::span in(memberships.in.data() + memberships.begin[j], memberships.in.data() + memberships.begin[j + 1]);
    const std::size_t first = rows.size();
    for (const auto& [ring, number] : in) {
      for (int e = begin_[index(ring)]; e < begin_[index(ring) + 1]; ++e) {
        const int i = member[index(e)];
        if (index(i) < j || at[index(i)] >= static_cast<int>(first)) continue;
        at[index(i)] = static_cast<int>(rows.size());
        rows.push_back(i);
      }
    }
    std::sort(rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end());
    for (std::size_t e = first; e < rows.size(); ++e) at[index(rows[e])] = static_cast<int>(e);
    for (const auto& [ring, number] : in) {
      for (int p = 0; p < begin_[index(ring) + 1] - begin_[index(ring)]; ++p) {
        const int i = member[index(begin_[index(ring)] + p)];
        if (index(i) < j) continue;
        const int upper = std::max(p, number);
        const int lower = std::min(p, number);
        place_[index(pairs[index(ring)] + upper * (upper + 1) / 2 + lower)] = at[index(i)];
      }
    }
    columns[j + 1] = static_cast<int>(rows.size());
  }
  const std::vector<double> zeros(rows.size(), 0.0);
  const auto n = static_cast<Eigen::Index>(unknowns);
  lower_ = Eigen::Map<const Eigen::SparseMatrix<double>>(n, n, static_cast<Eigen::Index>(rows.size()), columns.data(),
                                                         rows.data(), zeros.data());
  ++pattern_;
}

void RingMatrix::clear() {
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
}

double RingMatrix::multiply(std::span<const double> x, std::span<double> y) const {
  const int* const column = lower_.outerIndexPtr();
  const int* const row = lower_.innerIndexPtr();
  const double* const value = lower_.valuePtr();
  std::fill(y.begin(), y.end(), 0.0);
  double product = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double xj = x[j];
    double sum = value[column[j]] * xj;
    for (int e = column[j] + 1; e < column[j + 1]; ++e) {
      sum += value[e] * x[index(row[e])];
      y[index(row[e])] += value[e] * xj;
    }
    y[j] += sum;
    // Rows beyond j are not complete yet, but x_j times what column j gives is all of it that is met twice.
    product += xj * (2 * sum - value[column[j]] * xj);
  }
  return product;
}

void RingSolver::analyse(const RingMatrix& a) {
  constexpr double most_growth = 1.2;  // of the factor, before another order is looked for
  pattern_ = a.pattern();
  ++analyses_;
  if (cholesky_ && cholesky_->size() == a.size()) {
    const std::vector<int> ordering(cholesky_->ordering().begin(), cholesky_->ordering().end());
    cholesky_.emplace(a.lower(), ordering);
    if (cholesky_->work().entries <= fill_ * most_growth) return;
  }
  cholesky_.emplace(a.lower());
  fill_ = cholesky_->work().entries;
}

void RingSolver::factor(const RingMatrix& a, double shift) {
  if (a.pattern() != pattern_) analyse(a);
  matrix_ = &a;
  shifted_.assign(a.values().begin(), a.values().end());
  for (std::size_t j = 0; j < a.size(); ++j) shifted_[index(a.lower().outerIndexPtr()[j])] += shift;
  cholesky_->factor(shifted_);
  ++factorisations_;
}

void RingSolver::solve(std::span<const double> right_hand_side, std::span<double> x) {
  constexpr int refinements = 2;
  residual_.resize(x.size());
  cholesky_->solve(right_hand_side, x);
  for (int k = 0; k < refinements; ++k) {
    matrix_->multiply(x, residual_);
    for (std::size_t i = 0; i < x.size(); ++i) residual_[i] = right_hand_side[i] - residual_[i];
    cholesky_->solve(residual_, residual_);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += residual_[i];
  }
}

}  // namespace seiche::linear
