#include "seiche/linear/nine_point_solver.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "seiche/linear/lattice_gradients.hpp"
#include "seiche/linear/nine_point_cholesky.hpp"
#include "seiche/linear/nine_point_sparse.hpp"
#include "seiche/require.hpp"

namespace seiche::linear {

namespace {

constexpr std::array methods{std::pair{NinePointMethod::automatic, std::string_view("automatic")},
                             std::pair{NinePointMethod::banded, std::string_view("banded")},
                             std::pair{NinePointMethod::sparse, std::string_view("sparse")},
                             std::pair{NinePointMethod::iterative, std::string_view("iterative")}};

NinePointMethod fitting(std::size_t columns, std::size_t rows, bool has_lattice) {
  if (std::min(columns, rows) <= (has_lattice ? 20U : widest_banded)) return NinePointMethod::banded;
  return has_lattice ? NinePointMethod::iterative : NinePointMethod::sparse;
}

}  // namespace

std::string_view name(NinePointMethod method) {
  return std::find_if(methods.begin(), methods.end(), [&](const auto& m) { return m.first == method; })->second;
}

NinePointMethod nine_point_method_named(std::string_view name) {
  for (const auto& [method, its_name] : methods) {
    if (its_name == name) return method;
  }
  throw std::invalid_argument(fmt::format("solver = \"{}\"; allowed: automatic, banded, sparse, iterative", name));
}

class NinePointSolver::Implementation {
 public:
  virtual ~Implementation() = default;
  virtual void factor(const NinePointMatrix& a) = 0;
  /// Returns the iterations taken.
  virtual int solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) = 0;
  [[nodiscard]] virtual FactorWork factor_work() const = 0;
};

template <class Cholesky>
class NinePointSolver::Direct final : public Implementation {
 public:
  Direct(std::size_t columns, std::size_t rows) : cholesky_(columns, rows) {}
  void factor(const NinePointMatrix& a) override { cholesky_.factor(a); }
  int solve(std::span<const double> right_hand_side, std::span<double> x, double) override {
    cholesky_.solve(right_hand_side, x);
    return 0;
  }
  [[nodiscard]] FactorWork factor_work() const override { return cholesky_.work(); }

 private:
  Cholesky cholesky_;
};

class NinePointSolver::Iterative final : public Implementation {
 public:
  explicit Iterative(UndeformedLattice undeformed) : gradients_(std::move(undeformed)) {}
  void factor(const NinePointMatrix& a) override { gradients_.factor(a); }
  int solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) override {
    return gradients_.solve(right_hand_side, x, tolerance);
  }
  [[nodiscard]] FactorWork factor_work() const override { return {}; }

 private:
  LatticeGradients<NinePointMatrix> gradients_;
};

NinePointSolver::NinePointSolver(std::size_t columns, std::size_t rows, NinePointMethod method,
                                 std::optional<UndeformedLattice> undeformed, double tolerance)
    : method_(method == NinePointMethod::automatic ? fitting(columns, rows, undeformed.has_value()) : method),
      tolerance_(tolerance) {
  require_within("tolerance", tolerance, 1e-15, 1e-6);
  if (method_ == NinePointMethod::iterative && !undeformed) {
    throw std::invalid_argument("solver = \"iterative\"; allowed only for meshes between vertical walls, on a bottom");
  }
  if (method_ == NinePointMethod::banded) {
    implementation_ = std::make_unique<Direct<NinePointCholesky>>(columns, rows);
  } else if (method_ == NinePointMethod::sparse) {
    implementation_ = std::make_unique<Direct<NinePointSparse>>(columns, rows);
  } else {
    implementation_ = std::make_unique<Iterative>(*std::move(undeformed));
  }
}

NinePointSolver::~NinePointSolver() = default;
NinePointSolver::NinePointSolver(NinePointSolver&&) noexcept = default;
NinePointSolver& NinePointSolver::operator=(NinePointSolver&&) noexcept = default;

void NinePointSolver::factor(const NinePointMatrix& a) {
  implementation_->factor(a);
  ++factorisations_;
}

void NinePointSolver::solve(std::span<const double> right_hand_side, std::span<double> x, double tolerance) {
  last_iterations_ = implementation_->solve(right_hand_side, x, tolerance > 0 ? tolerance : tolerance_);
  iterations_ += last_iterations_;
  ++solutions_;
}

FactorWork NinePointSolver::factor_work() const {
  return implementation_->factor_work();
}

}  // namespace seiche::linear
