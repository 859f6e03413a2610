// Rows per second of the tridiagonal solvers.
#include <benchmark/benchmark.h>

#include <type_traits>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;

using TwoEnded = linear::TwoEndedTridiagonal;
struct Periodic : TwoEnded {
  void factor(linear::TridiagonalMatrix a) { TwoEnded::factor(a, true); }
};

/// Two diagonals and the right-hand side are read, the solution written; pivots and multipliers are written and read
/// (4 arrays). Elimination 3 + 2, substitution 3 operations; a periodic system is solved for two right-hand sides.
template <class Matrix>
constexpr performance::Work solution = std::is_same_v<Matrix, Periodic> ? performance::pass(12, 15)
                                                                        : performance::pass(8, 8);

template <class Matrix>
void factor_and_solve(benchmark::State& state) {
  const std::size_t n = performance::count_of(state);
  const std::vector<double> diagonal(n, 2.5), off_diagonal(n, -1), right_hand_side(n, 1);
  std::vector<double> x(n);
  Matrix matrix;
  for (auto _ : state) {
    matrix.factor({diagonal, off_diagonal});
    matrix.solve(right_hand_side, x);
    benchmark::DoNotOptimize(x.data());
  }
  performance::show(state, n, static_cast<double>(n) * solution<Matrix>);
}

BENCHMARK(factor_and_solve<TwoEnded>)->Arg(1000)->Arg(10000)->Arg(1000000);
BENCHMARK(factor_and_solve<Periodic>)->Arg(1000)->Arg(10000)->Arg(1000000);

}  // namespace
