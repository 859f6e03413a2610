// Cell-steps per second of the finite-volume schemes.
//
//   items_per_second  cells x steps / second
//   bytes_per_step, operations_per_step   work.hpp. Arrays that stay in a register between two uses count once; in a
//                     channel of several strips what leaves a strip: four arrays, read and written.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "verification/performance/work.hpp"

namespace {

namespace performance = seiche::performance;
using seiche::shallow_water_finite_volume::FiniteVolumeFlow;
using seiche::shallow_water_finite_volume::Scheme;

/// Courant test 2 reads; update: 2 fluxes, h, q read, h, q written; settle: h, q read, h written; primitives: h, q
/// read, u, c written: 15 passes, 2 + 6 + 6 + 4 = 18 operations. Fluxes: 2 writes and
///   Lax-Friedrichs  3 reads, 24 operations
///   MacCormack      4 + 3 reads, 2 + 2 more writes, 16 + 58 operations
///   Roe             4 reads, 64 operations
/// MUSCL: reconstruction 2 reads, 4 writes, 2 x 12 + 8 operations; HLL 4 reads, 2 writes, 46 operations; that and the
/// update twice; Heun 8 passes, 4 operations.
performance::Work work_of(Scheme scheme, std::size_t cells) {
  constexpr std::size_t several_strips = 1024;
  const auto work = [cells](double arrays, double operations) {
    return performance::pass(cells < several_strips ? arrays : 8, operations);
  };
  switch (scheme) {
    case Scheme::lax_friedrichs:
      return work(15 + 5, 18 + 24);
    case Scheme::mac_cormack:
      return work(15 + 13, 18 + 74);
    case Scheme::roe:
      return work(15 + 6, 18 + 64);
    case Scheme::muscl_hll:
      return work(2 + 2 * (13 + 12) + 8, 2 + 2 * (16 + 32 + 46) + 4);
  }
  return {};
}

void finite_volume_steps(benchmark::State& state, Scheme scheme) {
  const std::size_t cells = performance::count_of(state);
  const performance::Threads threads(state.range(1));
  std::vector<double> depth(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    depth[i] = 1 + 0.1 * std::sin(50.0 * static_cast<double>(i) / static_cast<double>(cells));
  }
  FiniteVolumeFlow flow({.scheme = scheme}, 0, 100, depth, std::vector<double>(cells, 0.0));
  const double tau = 0.2 / flow.courant_number(1);
  for (auto _ : state) flow.advance(tau);
  performance::show(state, cells, static_cast<double>(cells) * work_of(scheme, cells));
  benchmark::DoNotOptimize(flow.depth().data());
}

BENCHMARK_CAPTURE(finite_volume_steps, lax_friedrichs, Scheme::lax_friedrichs)->Apply(performance::rows_and_threads);
BENCHMARK_CAPTURE(finite_volume_steps, mac_cormack, Scheme::mac_cormack)->Apply(performance::rows_and_threads);
BENCHMARK_CAPTURE(finite_volume_steps, roe, Scheme::roe)->Apply(performance::rows_and_threads);
BENCHMARK_CAPTURE(finite_volume_steps, muscl_hll, Scheme::muscl_hll)->Apply(performance::rows_and_threads);

}  // namespace
