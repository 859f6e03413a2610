#include "seiche/linear/sparse_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <vector>

#include <cholmod.h>
#include <fmt/format.h>
#include <omp.h>
#include <Eigen/CholmodSupport>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/require_that.hpp"

namespace seiche::linear {

namespace {

/// CHOLMOD opens parallel regions of four threads, however many the program was given: small matrices then wait for
/// threads that have no core. While an object of this class lives they stay on the calling thread.
class OnOneThread {
 public:
  OnOneThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~OnOneThread() { omp_set_max_active_levels(levels_); }
  OnOneThread(const OnOneThread&) = delete;
  OnOneThread& operator=(const OnOneThread&) = delete;
  OnOneThread(OnOneThread&&) = delete;
  OnOneThread& operator=(OnOneThread&&) = delete;

 private:
  int levels_;
};

std::size_t index(int k) {
  return static_cast<std::size_t>(k);
}

}  // namespace

struct SparseCholesky::Cholmod {
  Cholmod(const Eigen::SparseMatrix<double>& matrix, std::span<const int> ordering) : pattern(matrix) {
    cholmod_start(&common);
    common.print = 0;
    common.final_ll = 1;  // L D L^T would accept negative pivots
    cholmod_sparse a = view();
    if (ordering.empty()) {
      factor = cholmod_analyze(&a, &common);
    } else {
      common.nmethods = 1;
      common.method[0].ordering = CHOLMOD_GIVEN;
      std::vector<int> given(ordering.begin(), ordering.end());
      factor = cholmod_analyze_p(&a, given.data(), nullptr, 0, &common);
    }
    work = {common.lnz, common.fl};
    if (factor == nullptr) {
      cholmod_finish(&common);
      throw std::bad_alloc();
    }
  }
  ~Cholmod() {
    for (cholmod_dense** const dense : {&x, &y, &e}) cholmod_free_dense(dense, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  Cholmod(Cholmod&&) = delete;
  Cholmod& operator=(Cholmod&&) = delete;

  /// The pattern with its values as CHOLMOD sees it.
  cholmod_sparse view() {
    cholmod_sparse a = Eigen::viewAsCholmod<double, Eigen::ColMajor, int>(pattern);
    a.stype = -1;
    return a;
  }

  Eigen::SparseMatrix<double> pattern;
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  FactorWork work;
  cholmod_dense* x = nullptr;  // solution and work, kept from one solution to the next
  cholmod_dense* y = nullptr;
  cholmod_dense* e = nullptr;
};

namespace {

void require_lower(const Eigen::SparseMatrix<double>& pattern) {
  require_that(pattern.rows() == pattern.cols() && pattern.rows() != 0 && pattern.isCompressed(),
               "pattern is {} x {}{}; allowed: square, not empty, compressed", pattern.rows(), pattern.cols(),
               pattern.isCompressed() ? "" : ", not compressed");
  for (int column = 0; column < pattern.cols(); ++column) {
    const int begin = pattern.outerIndexPtr()[column];
    const int end = pattern.outerIndexPtr()[column + 1];
    require_that(begin != end && pattern.innerIndexPtr()[begin] == column,
                 "pattern: column {} does not begin with its diagonal; allowed: lower triangle", column);
  }
}

}  // namespace

SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double>& pattern, std::span<const int> ordering) {
  require_lower(pattern);
  require_that(ordering.empty() || ordering.size() == static_cast<std::size_t>(pattern.cols()),
               "ordering has {} unknowns; the pattern has {}", ordering.size(), pattern.cols());
  cholmod_ = std::make_unique<Cholmod>(pattern, ordering);
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

std::size_t SparseCholesky::size() const {
  return cholmod_->factor->n;
}

std::span<const int> SparseCholesky::ordering() const {
  return {static_cast<const int*>(cholmod_->factor->Perm), size()};
}

FactorWork SparseCholesky::work() const {
  return cholmod_->work;
}

double SparseCholesky::pivot_ratio() const {
  return cholmod_rcond(cholmod_->factor, &cholmod_->common);
}

void SparseCholesky::factor(std::span<const double> values) {
  Cholmod& c = *cholmod_;
  const auto count = static_cast<std::size_t>(c.pattern.nonZeros());
  require_that(values.size() == count, "{} values; the pattern has {}", values.size(), count);
  // CHOLMOD compares pivots with zero, which NaN and infinity pass.
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (bad != values.end()) {
    const int* const begin = c.pattern.outerIndexPtr();
    const auto* const column = std::upper_bound(begin, begin + size() + 1, bad - values.begin()) - 1;
    throw NotPositiveDefinite(static_cast<std::size_t>(column - begin), *bad);
  }
  std::copy(values.begin(), values.end(), c.pattern.valuePtr());
  cholmod_sparse a = c.view();
  const OnOneThread guard;
  cholmod_factorize(&a, c.factor, &c.common);
  if (c.common.status == CHOLMOD_NOT_POSDEF) {
    const auto row = static_cast<std::size_t>(static_cast<const int*>(c.factor->Perm)[c.factor->minor]);
    throw NotPositiveDefinite(row);
  }
  if (c.common.status < CHOLMOD_OK) throw std::bad_alloc();
}

void SparseCholesky::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  Cholmod& c = *cholmod_;
  cholmod_dense b{};
  b.nrow = b.nzmax = b.d = size();
  b.ncol = 1;
  b.x = const_cast<double*>(right_hand_side.data());  // read only
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const OnOneThread guard;
  if (cholmod_solve2(CHOLMOD_A, c.factor, &b, nullptr, &c.x, nullptr, &c.y, &c.e, &c.common) == 0) {
    throw std::bad_alloc();
  }
  std::copy_n(static_cast<const double*>(c.x->x), size(), x.data());
}

void RingMatrix::set_rings(std::span<const int> begin, std::span<const int> member, std::size_t unknowns) {
  begin_.assign(begin.begin(), begin.end());
  // Pairs in the order in which sum() goes through them.
  const auto each_pair = [&](const auto& visit) {
    std::size_t pair = 0;
    for (std::size_t k = 0; k + 1 < begin_.size(); ++k) {
      for (const int* p = &member[index(begin_[k])]; p < member.data() + begin_[k + 1]; ++p) {
        for (const int* q = &member[index(begin_[k])]; q <= p; ++q) visit(std::min(*p, *q), std::max(*p, *q), pair++);
      }
    }
  };
  struct Pair {
    int row;
    std::size_t number;
  };
  std::vector<std::size_t> first(unknowns + 1, 0);  // of the pairs of a column
  each_pair([&](int column, int, std::size_t) { ++first[index(column) + 1]; });
  for (std::size_t j = 0; j < unknowns; ++j) {
    require_that(first[j + 1] != 0, "unknown {} is in no ring", j);
    first[j + 1] += first[j];
  }
  std::vector<Pair> pairs(first.back());
  std::vector<std::size_t> end = first;
  each_pair([&](int column, int row, std::size_t number) { pairs[end[index(column)]++] = {row, number}; });
  place_.resize(pairs.size());
  std::vector<int> columns{0}, rows;
  for (std::size_t j = 0; j < unknowns; ++j) {
    const std::span column(pairs.data() + first[j], pairs.data() + end[j]);
    std::ranges::sort(column, {}, &Pair::row);
    for (const auto& [row, number] : column) {
      if (static_cast<int>(rows.size()) == columns.back() || rows.back() != row) rows.push_back(row);
      place_[number] = static_cast<int>(rows.size()) - 1;
    }
    columns.push_back(static_cast<int>(rows.size()));
  }
  const std::vector<double> zeros(rows.size(), 0.0);
  const auto n = static_cast<Eigen::Index>(unknowns);
  lower_ = Eigen::Map<const Eigen::SparseMatrix<double>>(n, n, static_cast<Eigen::Index>(rows.size()), columns.data(),
                                                         rows.data(), zeros.data());
  ++pattern_;
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

std::optional<double> RingSolver::factor_or_singular(const RingMatrix& a, double mean, bool stabilised) {
  constexpr double shift = 1e-12;  // for the factor alone: without a free surface a constant pressure has no force
  try {
    // With a shift a singular matrix would look regular: its smallest pivot grows with the number of rows.
    factor(a, stabilised ? shift * mean : 0);
  } catch (const NotPositiveDefinite&) {
    if (stabilised) throw;
    return 0;
  }
  if (stabilised || pivot_ratio() >= smallest_pivot) return {};
  return pivot_ratio();
}

void RingSolver::solve(std::span<const double> right_hand_side, std::span<double> x) {
  constexpr int refinements = 2;
  const auto size = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::VectorXd> wanted(right_hand_side.data(), size);
  Eigen::Map<Eigen::VectorXd> solution(x.data(), size);
  cholesky_->solve(right_hand_side, x);
  for (int k = 0; k < refinements; ++k) {
    residual_ = wanted - matrix_->lower().selfadjointView<Eigen::Lower>() * solution;
    cholesky_->solve({residual_.data(), x.size()}, {residual_.data(), x.size()});
    solution += residual_;
  }
}

}  // namespace seiche::linear
