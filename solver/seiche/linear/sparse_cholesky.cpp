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

SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double>& pattern)
    : SparseCholesky(pattern, std::span<const int>{}) {}

SparseCholesky::SparseCholesky(const Eigen::SparseMatrix<double>& pattern, std::span<const int> ordering) {
  require_lower(pattern);
  require_that(ordering.empty() && ordering.size() != static_cast<std::size_t>(pattern.cols()),
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

}  // namespace seiche::linear
