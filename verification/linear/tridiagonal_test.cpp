// Tridiagonal solvers against dense Cholesky of Eigen.
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Dense>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/samples.hpp"
#include "verification/all_hold.hpp"
#include "verification/check.hpp"

namespace seiche::verification::tridiagonal_test {

using namespace linear;

struct Problem {
  std::vector<double> diagonal, off_diagonal, right_hand_side;
  Eigen::VectorXd expected;
};

/// Random couplings of either sign; each diagonal entry exceeds the sum of its row's couplings by `excess` of it.
Problem random_problem(std::size_t n, bool periodic, double excess, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Problem p;
  p.off_diagonal.resize(n);
  for (double& e : p.off_diagonal) e = unit(random);
  if (!periodic) p.off_diagonal.back() = 0;
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd b(size);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = p.off_diagonal[(i + n - 1) % n];
    p.diagonal.push_back((std::abs(before) + std::abs(p.off_diagonal[i])) * (1 + excess) + 0.01);
    p.right_hand_side.push_back(unit(random));
    const auto k = static_cast<Eigen::Index>(i);
    const auto next = static_cast<Eigen::Index>((i + 1) % n);
    dense(k, k) = p.diagonal[i];
    b[k] = p.right_hand_side[i];
    if (i + 1 == n && !periodic) continue;
    dense(k, next) += p.off_diagonal[i];
    dense(next, k) += p.off_diagonal[i];
  }
  p.expected = dense.llt().solve(b);
  return p;
}

/// TwoEndedSweep in the shape of the others: rows become known and unknowns wanted in pieces of `piece` rows. In place:
/// multipliers take the places of couplings, unknowns those of the right-hand side.
template <std::ptrdiff_t piece, bool in_place = false>
struct InPieces {
  std::vector<double> diagonal, off_diagonal, multiplier;
  void factor(TridiagonalMatrix a) {
    diagonal.assign(a.diagonal.begin(), a.diagonal.end());
    off_diagonal.assign(a.off_diagonal.begin(), a.off_diagonal.end());
    multiplier.resize(diagonal.size());
    std::vector<double> nothing(diagonal.size());
    solve(nothing, nothing);  // a bad pivot is found here
  }
  void solve(std::span<const double> right_hand_side, std::span<double> x) {
    const auto n = static_cast<std::ptrdiff_t>(diagonal.size());
    std::vector<double> b(right_hand_side.begin(), right_hand_side.end());
    TwoEndedSweep sweep;
    if (in_place) std::copy(off_diagonal.begin(), off_diagonal.end(), multiplier.begin());
    sweep.begin({diagonal.data(), in_place ? multiplier.data() : off_diagonal.data(), b.data(), multiplier.data(),
                 in_place ? b.data() : x.data()},
                n);
    for (std::ptrdiff_t known = piece; known < n + piece; known += piece) sweep.eliminate(known, n - known);
    sweep.join();
    for (std::ptrdiff_t wanted = piece; wanted < n + piece; wanted += piece) {
      sweep.substitute(std::max<std::ptrdiff_t>(n / 2 - wanted, 0), std::min(n / 2 + wanted, n));
    }
    if (in_place) std::copy(b.begin(), b.end(), x.begin());
  }
};

struct Ring : TwoEndedTridiagonal {
  void factor(TridiagonalMatrix a) { TwoEndedTridiagonal::factor(a, true); }
};

template <class Solver>
double largest_error(bool periodic) {
  Largest largest;
  unsigned seed = 1;
  for (const std::size_t n : {1, 2, 3, 4, 5, 6, 7, 10, 33, 100, 257}) {
    if (periodic && n < 3) continue;
    for (const double excess : {0.0, 0.1, 1.0}) {
      const Problem p = random_problem(n, periodic, excess, ++seed);
      Solver solver;
      solver.factor({p.diagonal, p.off_diagonal});
      std::vector<double> x = p.right_hand_side;
      solver.solve(x, x);
      const Eigen::Map<const Eigen::VectorXd> found(x.data(), static_cast<Eigen::Index>(n));
      largest.add(worst(found - p.expected) / worst(p.expected));
    }
  }
  return largest.value();
}

TEST_CASE("tridiagonal solvers agree with dense elimination", "[linear]") {
  Check check("tridiagonal_solvers", "Tridiagonal solvers against dense Cholesky",
              "Random symmetric positive definite systems of 1 to 257 rows, from barely to strongly diagonally "
              "dominant, solved in place, against Eigen's dense LLT.");
  all_hold(
      check, Bound{1e-12, "condition number up to 1e3 times a few roundings per row, here and in the dense solver"},
      {{"Elimination from both ends solves the tridiagonal system.", largest_error<TwoEndedTridiagonal>(false)},
       {"Elimination from both ends, row by row.", largest_error<InPieces<1>>(false)},
       {"Elimination from both ends, seven rows at a time.", largest_error<InPieces<7>>(false)},
       {"Elimination from both ends, multipliers in the place of couplings.", largest_error<InPieces<7, true>>(false)},
       {"Periodic elimination solves the periodic tridiagonal system.", largest_error<Ring>(true)}});
}

TEST_CASE("a matrix that is not positive definite is rejected with its row", "[linear]") {
  std::vector<double> diagonal(9, 2.0);
  const std::vector<double> off_diagonal(9, -1.0);
  TwoEndedTridiagonal solver;
  for (std::size_t row = 0; row < 9; ++row) {
    auto bad = diagonal;
    InPieces<2> sweep;
    for (const double pivot : {std::nan(""), -5.0}) {
      bad[row] = pivot;
      CHECK_THROWS_AS(solver.factor({bad, off_diagonal}), NotPositiveDefinite);
      CHECK_THROWS_AS(sweep.factor({bad, off_diagonal}), NotPositiveDefinite);
    }
    CHECK_THROWS_MATCHES(
        solver.factor({bad, off_diagonal}), NotPositiveDefinite,
        Catch::Predicate<NotPositiveDefinite>([row](const auto& error) { return error.row() == row; }));
  }
  CHECK_THROWS_AS(solver.factor({{}, off_diagonal}), std::invalid_argument);
  CHECK_THROWS_AS(solver.factor({diagonal, std::span(off_diagonal).first(7)}), std::invalid_argument);
  Ring periodic;
  CHECK_THROWS_AS(periodic.factor({std::span(diagonal).first(2), off_diagonal}), std::invalid_argument);
  CHECK_THROWS_AS(periodic.factor({std::vector<double>(9, 1.9), off_diagonal}), NotPositiveDefinite);
}

}  // namespace seiche::verification::tridiagonal_test
