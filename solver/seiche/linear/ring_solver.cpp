#include "seiche/linear/ring_solver.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <Eigen/IterativeLinearSolvers>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/tridiagonal.hpp"
#include "seiche/require.hpp"

namespace seiche::linear {

RingMethod ring_method_named(std::string_view name) {
  if (name == "automatic") return RingMethod::automatic;
  if (name == "direct") return RingMethod::direct;
  if (name == "iterative") return RingMethod::iterative;
  throw std::invalid_argument(fmt::format("solver = \"{}\"; allowed: automatic, direct, iterative", name));
}

class RingSolver::Implementation {
 public:
  virtual ~Implementation() = default;
  virtual void analyse(const RingMatrix& a) = 0;
  virtual void factor(const RingMatrix& a, double shift) = 0;
  /// Returns the number of iterations.
  virtual int solve(std::span<const double> right_hand_side, std::span<double> x) = 0;
  [[nodiscard]] virtual double pivot_ratio() const = 0;
  [[nodiscard]] virtual FactorWork factor_work() const = 0;
};

class RingSolver::Direct final : public Implementation {
 public:
  void analyse(const RingMatrix& a) override {
    if (cholesky_ && cholesky_->size() == a.size()) {
      ordering_.assign(cholesky_->ordering().begin(), cholesky_->ordering().end());
      cholesky_.emplace(a.lower(), ordering_);
      if (cholesky_->work().entries <= fill_ * most_growth) return;
    }
    cholesky_.emplace(a.lower());
    fill_ = cholesky_->work().entries;
  }

  void factor(const RingMatrix& a, double shift) override {
    matrix_ = &a;
    shifted_.assign(a.values().begin(), a.values().end());
    for (std::size_t j = 0; j < a.size(); ++j) {
      shifted_[static_cast<std::size_t>(a.lower().outerIndexPtr()[j])] += shift;
    }
    cholesky_->factor(shifted_);
  }

  int solve(std::span<const double> right_hand_side, std::span<double> x) override {
    residual_.resize(x.size());
    cholesky_->solve(right_hand_side, x);
    for (int k = 0; k < refinements; ++k) {
      matrix_->multiply(x, residual_);
      for (std::size_t i = 0; i < x.size(); ++i) residual_[i] = right_hand_side[i] - residual_[i];
      cholesky_->solve(residual_, residual_);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += residual_[i];
    }
    return 0;
  }

  [[nodiscard]] double pivot_ratio() const override { return cholesky_->pivot_ratio(); }
  [[nodiscard]] FactorWork factor_work() const override { return cholesky_->work(); }

 private:
  static constexpr int refinements = 2;
  static constexpr double most_growth = 1.2;  // of the factor, before another order is looked for

  const RingMatrix* matrix_ = nullptr;
  std::optional<SparseCholesky> cholesky_;
  double fill_ = 0;
  std::vector<int> ordering_;
  std::vector<double> shifted_, residual_;
};

class RingSolver::Iterative final : public Implementation {
 public:
  explicit Iterative(double tolerance) : tolerance_(tolerance) {}

  void analyse(const RingMatrix& a) override { incomplete_.analyzePattern(a.lower()); }

  void factor(const RingMatrix& a, double /*shift*/) override {
    matrix_ = &a;
    incomplete_.factorize(a.lower());
    if (incomplete_.info() != Eigen::Success) throw NotPositiveDefinite(0);
  }

  int solve(std::span<const double> right_hand_side, std::span<double> x) override {
    b_.numbers.assign(right_hand_side.begin(), right_hand_side.end());
    x_.numbers.assign(x.begin(), x.end());
    const auto multiply = [this](const Numbers& p, Numbers& q) { return matrix_->multiply(p.numbers, q.numbers); };
    const auto precondition = [this](std::span<const double> r, std::span<double> z, double /*magnitude*/) {
      const auto n = static_cast<Eigen::Index>(r.size());
      Eigen::Map<Eigen::VectorXd>(z.data(), n) = incomplete_.solve(Eigen::Map<const Eigen::VectorXd>(r.data(), n));
    };
    const auto result =
        gradients_.solve(multiply, precondition, b_, x_, {.tolerance = tolerance_, .most_iterations = most_iterations});
    std::copy(x_.numbers.begin(), x_.numbers.end(), x.begin());
    return result.iterations;
  }

  [[nodiscard]] double pivot_ratio() const override { return 1; }
  [[nodiscard]] FactorWork factor_work() const override { return {}; }

 private:
  static constexpr int most_iterations = 5000;

  struct Numbers {
    std::vector<double> numbers;
    [[nodiscard]] std::span<double> values() { return numbers; }
    [[nodiscard]] std::span<const double> values() const { return numbers; }
  };

  double tolerance_;
  const RingMatrix* matrix_ = nullptr;
  Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> incomplete_;
  ConjugateGradients<Numbers> gradients_;
  Numbers b_, x_;
};

RingSolver::RingSolver(std::size_t unknowns, RingMethod method, double tolerance) : method_(method) {
  require_within("tolerance", tolerance, std::numeric_limits<double>::epsilon(), 1e-6);
  if (method_ == RingMethod::automatic) {
    method_ = unknowns <= most_direct ? RingMethod::direct : RingMethod::iterative;
  }
  if (method_ == RingMethod::direct) {
    implementation_ = std::make_unique<Direct>();
  } else {
    implementation_ = std::make_unique<Iterative>(tolerance);
  }
}

RingSolver::~RingSolver() = default;
RingSolver::RingSolver(RingSolver&&) noexcept = default;
RingSolver& RingSolver::operator=(RingSolver&&) noexcept = default;

void RingSolver::factor(const RingMatrix& a, double shift) {
  if (a.pattern() != pattern_) {
    implementation_->analyse(a);
    pattern_ = a.pattern();
    ++analyses_;
  }
  implementation_->factor(a, shift);
  ++factorisations_;
}

void RingSolver::solve(std::span<const double> right_hand_side, std::span<double> x) {
  iterations_ += implementation_->solve(right_hand_side, x);
}

double RingSolver::pivot_ratio() const {
  return implementation_->pivot_ratio();
}

FactorWork RingSolver::factor_work() const {
  return implementation_->factor_work();
}

}  // namespace seiche::linear
