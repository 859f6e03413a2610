// What this machine can do on one core, beside which the other benchmarks are read.
//
//   triad   a = b + s c over arrays of the given length: bytes_per_second of the two reads and the write that the
//   source
//           names. 1000 entries stay in the first cache, 1e7 are 240 MB.
//   fused   multiplications and additions on registers: operations_per_second, the peak of the vector unit that the
//           flags of this build allow.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

namespace {

void triad(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  std::vector<double> sum(n, 0.0);
  const std::vector<double> first(n, 1.0), second(n, 2.0);
  double scale = 3;
  for (auto _ : state) {
    benchmark::DoNotOptimize(scale);
    double* __restrict a = sum.data();
    const double* b = first.data();
    const double* c = second.data();
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + scale * c[i];
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetBytesProcessed(state.iterations() * state.range(0) * 3 * static_cast<long>(sizeof(double)));
}

void fused(benchmark::State& state) {
  // Chains enough to hide the latency of the unit, few enough to stay in registers.
  constexpr int width = 8;
  constexpr int chains = 10;
  using Pack = double __attribute__((vector_size(width * sizeof(double))));
  constexpr int rounds = 1000;
  Pack sums[chains] = {};
  Pack factor = Pack{} + 0.999999;
  Pack term = Pack{} + 1e-6;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(term);
  for (auto _ : state) {
    for (int k = 0; k < rounds; ++k) {
#pragma GCC unroll 10
      for (Pack& sum : sums) sum = sum * factor + term;
    }
    benchmark::DoNotOptimize(sums);
  }
  state.counters["operations_per_second"] =
      benchmark::Counter(2.0 * width * chains * rounds, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(triad)->Arg(1000)->Arg(10000000);
BENCHMARK(fused);

}  // namespace
