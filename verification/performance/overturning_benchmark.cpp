// The overturning wave over a bottom: one integral equation, and the whole motion up to touch-down.
#include <benchmark/benchmark.h>

#include "seiche/exact/overturning/evolution.hpp"
#include "seiche/exact/overturning/overturning_wave.hpp"
#include "seiche/exact/overturning/surface_velocity.hpp"
#include "verification/performance/work.hpp"

namespace {

using namespace seiche::exact;

constexpr double depth = 0.816814089933346;
constexpr double amplitude = 0.408407044966673;

/// From a first guess of zero: two passes in double precision. A pair of markers takes about 50 operations once per
/// pass and 2 per iteration; its coefficient, in single precision, is written in a pass and read in an iteration.
void integral_equation(benchmark::State& state) {
  const std::size_t markers = seiche::performance::count_of(state);
  const overturning::State initial = overturning::sinusoidal_wave(markers, amplitude, depth);
  overturning::SurfaceVelocity velocity(markers, depth);
  Eigen::VectorXd psi_s(state.range(0));
  for (auto _ : state) {
    psi_s.setZero();
    velocity.solve(overturning::view(initial), psi_s);
    benchmark::DoNotOptimize(psi_s.data());
  }
  const double iterations = static_cast<double>(velocity.iterations()) / static_cast<double>(velocity.solves());
  state.counters["iterations"] = iterations;
  constexpr double passes = 2;
  const auto pairs = static_cast<double>(markers * markers);
  seiche::performance::show(state, markers * markers,
                            {pairs * 4 * (passes + iterations), pairs * (50 * passes + 2 * iterations)});
}

void until_touch_down(benchmark::State& state) {
  std::size_t steps = 0;
  for (auto _ : state) {
    const OverturningWave wave(
        {.amplitude = amplitude, .depth = depth, .markers = seiche::performance::count_of(state)});
    steps = wave.steps();
  }
  state.counters["steps"] = static_cast<double>(steps);
  seiche::performance::show_not_counted(state, "adaptive");
}

}  // namespace

BENCHMARK(integral_equation)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(until_touch_down)->Arg(256)->Arg(512)->Unit(benchmark::kSecond)->Iterations(1);
