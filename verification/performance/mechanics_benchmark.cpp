// Rows per second of the tridiagonal solvers, and marker-steps per second of the integrators on a flat channel.
#include <benchmark/benchmark.h>

#include <type_traits>
#include <vector>

#include "seiche/linear/tridiagonal.hpp"
#include "seiche/mechanics/conservative_step.hpp"
#include "seiche/mechanics/one_step.hpp"
#include "seiche/mechanics/start.hpp"
#include "verification/conservation/flat_channel.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche;

/// Two diagonals and the right-hand side are read, the solution written; pivots and multipliers are written and read
/// (4 arrays). Elimination 3 + 2, substitution 3 operations; a periodic system is solved for two right-hand sides.
template <class Matrix>
constexpr performance::Work solution = std::is_same_v<Matrix, linear::PeriodicTridiagonal> ? performance::pass(12, 15)
                                                                                           : performance::pass(8, 8);

template <class Matrix>
void factor_and_solve(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> diagonal(n, 2.5);
  const std::vector<double> off_diagonal(n, -1);
  const std::vector<double> right_hand_side(n, 1);
  std::vector<double> x(n);
  Matrix matrix;
  for (auto _ : state) {
    matrix.factor({diagonal, off_diagonal});
    matrix.solve(right_hand_side, x);
    benchmark::DoNotOptimize(x.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  performance::show(state, static_cast<double>(n) * solution<Matrix>);
}

template <template <class> class Stepper, class Matrix>
void channel_steps(benchmark::State& state) {
  using Channel = verification::FlatChannel<Matrix>;
  const auto n = static_cast<std::size_t>(state.range(0));
  const double length = 0.25 * static_cast<double>(n);
  mechanics::State flow = verification::solitary_start(0.1, length, n, Channel::periodic);
  Channel channel(flow.q, length);
  mechanics::Start(channel).project(flow);
  Stepper<Channel> stepper(channel);
  for (auto _ : state) stepper.step(flow, 0.05);
  state.SetItemsProcessed(state.iterations() * state.range(0));
  // As of channels between walls in dispersive_shallow_water_benchmark.cpp.
  performance::Work work = performance::pass(15, 94);
  if constexpr (requires { stepper.total_sweeps(); }) {
    const double sweeps = static_cast<double>(stepper.total_sweeps()) / static_cast<double>(flow.steps);
    work = performance::pass(sweeps * 19 + 4, sweeps * 119 + 12);
  }
  performance::show(state, static_cast<double>(n) * work);
  benchmark::DoNotOptimize(flow.q.data());
}

using TwoEnded = linear::TwoEndedTridiagonal;
using Periodic = linear::PeriodicTridiagonal;

BENCHMARK(factor_and_solve<TwoEnded>)->Arg(1000)->Arg(10000)->Arg(1000000);
BENCHMARK(factor_and_solve<Periodic>)->Arg(1000)->Arg(10000)->Arg(1000000);
BENCHMARK(channel_steps<mechanics::OneStep, TwoEnded>)->Arg(1000)->Arg(10000)->Arg(1000000);
BENCHMARK(channel_steps<mechanics::ConservativeStep, TwoEnded>)->Arg(1000)->Arg(10000)->Arg(1000000);

}  // namespace
